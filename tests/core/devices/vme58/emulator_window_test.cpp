// The window under a host that makes mistakes, and the board where there is no room.
#include "core/devices/vme58/emulator.h"
#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {

TEST(Vme58Window, AnIndexThatPointsNowhereIsNotFollowed) {
  Rig rig;
  for (std::uint16_t i = 0; i < ring_cells; ++i)
    rig.write16(static_cast<std::uint16_t>(at::output_buffer + 2 * i), "JG1000 ;"[i % 8]);
  for (const std::uint16_t index : {256, 300, 0x1001, 0xFFFF}) {
    rig.write16(at::output_put_index, index);
    EXPECT_TRUE(rig.command_error()) << index;
    EXPECT_EQ(rig.read16(at::output_get_index), 0) << "nothing was taken";
  }
  rig.run_for(1s);
  EXPECT_EQ(rig.view().load_position[0].value, 0);
  rig.write16(at::output_put_index, 0);
  EXPECT_EQ(rig.value("WY"), "VME58 ver 2.24-8S") << "a good index again: back at work";
  rig.write16(at::input_get_index, 999);
  EXPECT_TRUE(rig.command_error());
  rig.write16(at::input_get_index, rig.read16(at::input_put_index));
  EXPECT_EQ(rig.value("WY"), "VME58 ver 2.24-8S");
}

TEST(Vme58Window, AnIndexWrittenByteByByteCountsWithItsLowByte) {
  Rig rig;
  const std::string text = "AX LP7 ";
  for (std::size_t i = 0; i < text.size(); ++i)
    rig.write16(static_cast<std::uint16_t>(at::output_buffer + 2 * i), static_cast<std::uint8_t>(text[i]));
  rig.write8(at::output_put_index, 0);
  EXPECT_EQ(rig.read16(at::output_get_index), 0);
  rig.write8(at::output_put_index + 1, 7);
  EXPECT_EQ(rig.read16(at::output_get_index), 7);
}

TEST(Vme58Window, A32BitCycleIsTwoOf16WithTheHighHalfFirst) {
  Rig rig;
  rig.write32(at::reserved1, 0x12345678);
  EXPECT_EQ(rig.read16(at::reserved1), 0x1234);
  EXPECT_EQ(rig.read8(at::reserved1 + 3), 0x78);
  // Over the end of the window: on at its begin.
  EXPECT_EQ(rig.read32(window_bytes - 2) & 0xFFFF, rig.read16(0));
  // Status and user I/O in one access: the status first.
  rig.send("XX ");
  EXPECT_EQ(rig.read32(reg::status - 1), 0x000300FFu);
}

TEST(Vme58Window, AFullQueueHoldsTheTextBackAndLosesNothing) {
  Rig rig;
  rig.send("AX WT1000 ");
  for (int i = 0; i < 66; ++i) rig.send("MR1 GO ");  // 198 entries
  EXPECT_EQ(rig.room('X'), 0);
  rig.send("MR1000 GO RP");
  EXPECT_GT(rig.waiting(), 0);
  EXPECT_EQ(rig.output(), "") << "later queries wait as well (decision M19)";
  EXPECT_FALSE(rig.command_error());
  rig.run_for(10s);
  EXPECT_EQ(rig.waiting(), 0);
  rig.output();
  EXPECT_EQ(rig.position('X'), 1066);
}

TEST(Vme58Window, TheMailboxWorksWhileTheTextIsHeldBack) {
  Rig rig;
  rig.send("AX WH WT10 WG ");
  for (int i = 0; i < 65; ++i) rig.send("MR1 GO ");
  rig.send("MR1 MR1 JG100 WY");
  EXPECT_GT(rig.waiting(), 0);
  rig.run_for(100ms);
  rig.mail("KL");
  EXPECT_EQ(rig.output(), framed("VME58 ver 2.24-8S")) << "room, and the text goes on";
  rig.run_for(1s);
  EXPECT_EQ(rig.room('X'), queue_entries);
  EXPECT_EQ(rig.read32(at::mailbox), 0u);
}

TEST(Vme58Window, EverythingOfTheMailbox) {
  for (const std::string_view letters : mailbox_commands) {
    Rig rig;
    rig.mail(letters);
    EXPECT_FALSE(rig.command_error()) << letters;
    rig.run_for(200ms);
    EXPECT_EQ(rig.read8(reg::control), 0) << letters;
  }
  for (const std::string_view letters : {"GO", "AX", "sa", "S ", "ID", "WY", "LP", "\xFF\xFF"}) {
    Rig rig;
    rig.mail(letters);
    EXPECT_TRUE(rig.command_error()) << letters;
    EXPECT_EQ(rig.output(), "");
  }
}

TEST(Vme58Window, MailIsTakenOnceForOneRequest) {
  Rig rig;
  rig.mail("SA");
  rig.send("AX ID ");
  // Other bits are changed while the board has not taken the request back yet.
  rig.write16(at::mailbox, 'I');
  rig.write16(at::mailbox + 2, 'C');
  rig.write8(reg::control, rig.read8(reg::control) | control::done_interrupt);
  EXPECT_EQ(rig.done(), bit_of('X'));
}

TEST(Vme58Window, PowerOffLeavesAnEmptySlot) {
  Rig rig;
  rig.send("AX LP5 JG100 ");
  rig.operate(bench::Power(false));
  EXPECT_FALSE(rig.view().powered);
  EXPECT_EQ(rig.read8(reg::status), 0xFF);
  EXPECT_EQ(rig.read16(0), 0xFFFF);
  rig.write16(at::output_put_index, 5);
  rig.run_for(1s);
  EXPECT_FALSE(rig.bus().interrupt());
  rig.operate(bench::Power(true));
  EXPECT_EQ(rig.status(), 0) << "it boots";
  rig.run_for(100ms);
  EXPECT_EQ(rig.status(), status::initialized);
  EXPECT_EQ(rig.position('X'), 0);
  rig.operate(bench::PowerCycle{});
  rig.run_for(100ms);
  EXPECT_EQ(rig.value("WY"), "VME58 ver 2.24-8S");
}

TEST(Vme58Window, TextSentToABootingBoardIsLost) {
  Rig rig;
  rig.send("RS");
  rig.send("AX LP5 ");
  rig.write8(reg::control, 0x90);
  rig.mail("IC");
  rig.run_for(100ms);
  EXPECT_EQ(rig.read8(reg::control), 0);
  EXPECT_EQ(rig.read16(at::output_put_index), 0);
  EXPECT_EQ(rig.position('X'), 0);
}

TEST(Vme58Window, ACopyLivesItsOwnLife) {
  Rig rig;
  rig.send("AX VL1000 MR1000 GO ID ");
  rig.run_for(500ms);
  const auto copy = rig.emulator().clone();
  rig.send("KL");
  copy->advance_to(Instant(3s));
  EXPECT_EQ(bus_cycle(*copy->bus(), false, 1, reg::done), 1u);
  EXPECT_EQ(rig.done(), 0);
}

TEST(Vme58Window, OptionsThatMakeNoSense) {
  for (const DeviceOptions& options :
       {DeviceOptions{{"variant", "9S"}}, DeviceOptions{{"jumpers", "IO"}}, DeviceOptions{{"jumpers", "IXO"}},
        DeviceOptions{{"baud", "9600"}}, DeviceOptions{{"firmware", "new"}},
        DeviceOptions{{"velocity", "2000000"}}, DeviceOptions{{"acceleration", "0"}},
        DeviceOptions{{"contour_size", "many"}}, DeviceOptions{{"servo_update_us", "0"}}}) {
    const auto made = make_emulator(options);
    ASSERT_FALSE(made.has_value());
    EXPECT_NE(made.error().sentence().find(options.begin()->first), std::string::npos)
        << made.error().sentence();
  }
}

TEST(Vme58Window, ValuesLeftOpenByTheDataSheetCanBeConfigured) {
  Rig rig(DeviceOptions{{"velocity", "3000"},
                        {"acceleration", "7000"},
                        {"base_velocity", "20"},
                        {"contour_size", "50"},
                        {"firmware", "1.7"}});
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(rig.axis_value('S', AxisValue::maximum_velocity), 3000);
    EXPECT_EQ(rig.axis_value('X', AxisValue::acceleration), 7000);
    EXPECT_EQ(rig.axis_value('T', AxisValue::base_velocity), 20);
    EXPECT_EQ(rig.value("WY"), "VME58 ver 1.7-8S");
    rig.send("AA CV100 CD0,0; MT5,5 ");
    EXPECT_EQ(rig.value("RQ"), "47") << "three of fifty";
    rig.send("CK VL9,,,9;");
    rig.mail("RS");
    rig.run_for(1s);
  }
}

TEST(Vme58Window, ACommandThatTheEndOfTheRingCutsInTwo) {
  Rig rig;
  for (int put = 0; put < 248; put += 4) rig.send("    ");
  rig.send("  AX LP-1234567 ");
  EXPECT_EQ(rig.read16(at::output_put_index), 8) << "from cell 250 over the last one";
  EXPECT_EQ(rig.position('X'), -1234567);
  EXPECT_FALSE(rig.command_error());
}

TEST(Vme58Window, HandsOnWhatIsNotThere) {
  Rig rig = Rig::model("4");
  const auto refused = [&](const BenchCommand& hand) { return !rig.emulator().operate(hand).has_value(); };
  EXPECT_TRUE(refused(bench::Limit(AxisId{4}, Sign::plus, true)));
  EXPECT_TRUE(refused(bench::HomeSwitch(AxisId{7}, true)));
  EXPECT_TRUE(refused(bench::Input(0, true)));
  EXPECT_TRUE(refused(bench::Input(15, true)));
  EXPECT_TRUE(refused(bench::Input(9, true))) << "line 8 is an output";
  EXPECT_TRUE(refused(bench::Analog(1, 1)));
  EXPECT_TRUE(refused(bench::Button("Run", true)));
  EXPECT_TRUE(refused(bench::Alarm(AxisId{0}, true)));
  EXPECT_TRUE(refused(bench::Breaker(0, true)));
  EXPECT_FALSE(refused(bench::Input(8, true)));
}

}  // namespace hw::vme58::proof
