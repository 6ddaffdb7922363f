// Habits that the data sheet does not know and some boards have (decisions M97 to M100).
#include "core/devices/vme58/emulator.h"
#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {
namespace {

DeviceOptions quirk(const std::string& name) { return {{"quirk", name}}; }

// --- M97: the done register and the D of a status are two latches

TEST(Vme58Quirks, TheLetterDOutlivesAReadingOfTheDoneRegister) {
  Rig rig;
  rig.send("AX MR400 GO ID ");
  rig.run_for(5s);
  ASSERT_EQ(rig.done(), bit_of('X'));
  EXPECT_EQ(rig.done(), 0);
  EXPECT_EQ(rig.status() & status::done, 0);
  EXPECT_EQ(rig.value("QA"), "PDNN");
  EXPECT_EQ(rig.value("QI").substr(0, 4), "PDNN");
  EXPECT_EQ(rig.value("RA"), "PDNN") << "and is cleared by it";
  EXPECT_EQ(rig.value("QA"), "PNNN");
}

TEST(Vme58Quirks, CommandsThatClearTheLetterClearTheBitToo) {
  for (const char* clears : {"RA ", "RI ", "CA ", "IC ", "SD ", "MR10 GD "}) {
    Rig rig;
    rig.send("AX ID ");
    ASSERT_EQ(rig.value("QA"), "PDNN");
    rig.ask(clears);
    EXPECT_EQ(rig.value("QA"), "PNNN") << clears;
    EXPECT_EQ(rig.done(), 0) << clears;
  }
}

// --- M99

TEST(Vme58Quirks, PaddedNumbersHaveBlanksASignAndLeadingZeros) {
  Rig rig(quirk("padded"));
  rig.send("AX LP200 AY LP-12 ");
  EXPECT_EQ(rig.value("AX RP"), "  +000200");
  EXPECT_EQ(rig.value("AY RP"), "  -00012");
  EXPECT_EQ(rig.value("AA RP").substr(0, 18), "  +000200,  -00012");
  EXPECT_EQ(rig.value("AX RV"), "  +0000");
  EXPECT_EQ(rig.value("RQ"), "  +000200");
  EXPECT_EQ(rig.value("UU4 RU"), "  +00050.0");
  EXPECT_EQ(rig.value("RB"), "  +0003F00");
  EXPECT_EQ(rig.value("WY"), "VME58 ver 2.24-8S") << "is no number";
  EXPECT_EQ(Rig().value("AX RP"), "0") << "not by default";
}

// --- M98

TEST(Vme58Quirks, KkIsTakenOnServoAxesAndDoesNothing) {
  Rig sheet;
  sheet.send("AX KK2 ");
  EXPECT_TRUE(sheet.command_error()) << "not in the data sheet";
  Rig rig({{"quirk", "oms-kk"}, {"variant", "4S4"}});
  rig.send("AX KK2 ID ");
  EXPECT_FALSE(rig.command_error());
  EXPECT_EQ(rig.done(), bit_of('X')) << "what stands behind it is done";
  EXPECT_EQ(rig.axis_value('X', AxisValue::proportional_gain),
            Rig::model("4S4").axis_value('X', AxisValue::proportional_gain));
  rig.send("AU KK2 ");
  EXPECT_TRUE(rig.command_error()) << "a step axis";
  rig.send("RS ");
  rig.run_for(1s);
  rig.status();
  rig.send("AX KK2 ");
  EXPECT_FALSE(rig.command_error()) << "a reset changes no firmware";
}

// --- M100

TEST(Vme58Quirks, ADeafMailboxAcknowledgesAndDoesNothing) {
  Rig rig(quirk("deaf-mailbox"));
  rig.send("AX JG1000 ");
  rig.run_for(1s);
  rig.mail("KL");
  rig.run_for(1ms);
  EXPECT_EQ(rig.read8(reg::control) & control::interrupt_board, 0) << "acknowledged";
  EXPECT_FALSE(rig.command_error());
  rig.run_for(1s);
  EXPECT_EQ(rig.value("RV"), "1000") << "and nothing slows";
  rig.send("KL ");
  EXPECT_EQ(rig.value("RV"), "0") << "the ring works";
}

TEST(Vme58Quirks, SeveralAreJoinedAndAWrongOneIsNamed) {
  Rig rig(quirk("padded+oms-kk"));
  rig.send("AX KK2 ");
  EXPECT_FALSE(rig.command_error());
  EXPECT_EQ(rig.value("RP"), "  +0000");
  const auto wrong = make_emulator(quirk("padded+nonsense"));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().what, "A VME58 has no quirk \"nonsense\".");
}

}  // namespace
}  // namespace hw::vme58::proof
