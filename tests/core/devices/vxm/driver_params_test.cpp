#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;

class VxmDriverParams : public DriverTest {
 protected:
  const ParamState& state(const char* mnemonic) { return latest.params[catalog.find_param(mnemonic)]; }
};

TEST_F(VxmDriverParams, AreWrittenAndReadBack) {
  start();
  EXPECT_EQ(perform(intent::SetParam("j1M", 1000)), "");
  EXPECT_EQ(state("j1M").value, 1000);
  EXPECT_FALSE(state("j1M").stored);
  EXPECT_TRUE(latest.unsaved_setup);
  EXPECT_EQ(perform(intent::SetParam("L1M", -2)), "");
  EXPECT_EQ(state("L1M").value, -2);
  EXPECT_EQ(perform(intent::SetParam("Bx", 1)), "");
  EXPECT_EQ(state("Bx").value, 20) << "1 means 20 steps";
  EXPECT_EQ(perform(intent::SetParam("I", 128 + 7)), "");
  EXPECT_EQ(state("I").value, 133) << "the controller clears bit 1";
  EXPECT_EQ(perform(intent::SetParam("O", 3)), "");
  EXPECT_EQ(query("O"), "3");
  EXPECT_EQ(perform(intent::ReadParams()), "");
  EXPECT_EQ(state("PA").value, 1);
}

TEST_F(VxmDriverParams, OutOfRangeIsRefusedWithTheRange) {
  start();
  EXPECT_EQ(
      perform(intent::SetParam("J1M", 39)),
      "39 is not possible for J1M (Second jog speed of motor 1): it takes 40 to 6000. Nothing was sent.");
  EXPECT_EQ(perform(intent::SetParam("L1M", 4)),
            "4 is not possible for L1M (Limit switches of motor 1): it takes one of 0, 1, 2, -1, -2. Nothing "
            "was sent.");
  EXPECT_EQ(perform(intent::SetParam("XYZ", 4)), "A VXM has no parameter XYZ. Nothing was sent.");
}

TEST_F(VxmDriverParams, AMotorTypeNeedsAConfirmationThatNamesTheMotor) {
  start();
  sent();
  const std::string refusal = perform(intent::SetParam("M2M", 3));
  EXPECT_THAT(refusal, HasSubstr("motor 2"));
  EXPECT_THAT(refusal, HasSubstr("Nothing was sent. Confirm it to go on."));
  EXPECT_EQ(sent(), "");
  EXPECT_EQ(perform(intent::SetParam("M2M", 3, true)), "");
  EXPECT_EQ(state("M2M").value, 3);
  EXPECT_EQ(perform(intent::SetParam("MA1M", 2, true)), "");
  EXPECT_EQ(state("M1M").value, 2) << "the type is all that can be read";
}

TEST_F(VxmDriverParams, StoreShowsHowManyWritesAreKnown) {
  start();
  perform(intent::SetParam("j1M", 500));
  EXPECT_EQ(perform(intent::Store()), "");
  EXPECT_FALSE(latest.unsaved_setup);
  EXPECT_TRUE(state("j1M").stored);
  EXPECT_EQ(latest.store_count, -1);
  EXPECT_TRUE(reported("The memory is rated for about 100000 writes; the number used so far is unknown."));
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmDriverParams, TheBaudRateChangesOnBothSides) {
  start({}, true);
  loop->client_rate = 9600;
  EXPECT_EQ(perform(intent::SetParam("B", 38)), "");
  EXPECT_EQ(loop->client_rate, 38400);
  EXPECT_EQ(loop->emulator().rate(), 38400);
  EXPECT_EQ(query("X"), "+0000000");
  run(1);
  EXPECT_EQ(latest.link.state, LinkState::good);
}

TEST_F(VxmDriverParams, ResetIsAsPowerOffAndOn) {
  start();
  move_to(0, 100);
  wait_idle();
  EXPECT_EQ(perform(intent::Reset()), "");
  EXPECT_EQ(position(), 0);
  EXPECT_TRUE(reported("The controller was reset: its positions read zero where the motors are now"));
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmDriverParams, NothingIsSetWhileAProgramRuns) {
  start();
  move_by(0, 4000);
  EXPECT_EQ(perform(intent::SetParam("j1M", 500)),
            "The controller is busy and accepts no program commands. Nothing was sent. Wait until "
            "it ends, or stop it.");
}

// ---- raw text

class VxmDriverTalk : public DriverTest {};

TEST_F(VxmDriverTalk, QueriesGiveTheReplyWithoutItsEnd) {
  start();
  EXPECT_EQ(query("X"), "+0000000");
  EXPECT_EQ(query("V"), "R");
  EXPECT_EQ(query("PM"), "0");
  EXPECT_EQ(query("getM1M"), "0");
  EXPECT_EQ(query("~"), "\xFF");
  EXPECT_EQ(query("lst"), "PM0 M256");
  EXPECT_EQ(query("x"), "+0000000\r+0000000\r+0000000\r+0000000");
  EXPECT_EQ(query("K"), "^");
  EXPECT_EQ(query("I1M10,R", 5), "^");
  EXPECT_EQ(query("C", 0.2), "fault: No reply came within 0.2 s.");
}

TEST_F(VxmDriverTalk, TextIsSentAsItIsAndClosed) {
  start();
  sent();
  EXPECT_EQ(send("I1M400"), "");
  EXPECT_EQ(sent(), "I1M400\r");
  EXPECT_EQ(send("R"), "");
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 400);
  EXPECT_EQ(unsolicited(), "^");
  run(0.5);
  EXPECT_EQ(latest.slot_bytes_used[0], 4);
}

TEST_F(VxmDriverTalk, CommandsThatTheControllerIgnoresSilentlyAreReported) {
  start();
  EXPECT_EQ(send("U10,"), "");
  EXPECT_TRUE(
      reported("Send U10 again with another number: it takes one of the manual's U commands. U10 was sent as "
               "typed, and the controller ignores it silently."))
      << all_notices();
  EXPECT_EQ(send("%"), "");
  EXPECT_TRUE(reported(
      "% is not a command of the VXM, and the controller ignores it silently. It was sent as typed."));
  EXPECT_EQ(send("S1M8000,"), "");
  EXPECT_TRUE(reported(
      "Send S1M8000 again with another number: it takes 1 to 6000 steps/s. S1M8000 was sent as typed"));
  EXPECT_EQ(query("M"), "256");
}

TEST_F(VxmDriverTalk, MovesOfTheConsoleLeaveNoPromptForScripts) {
  start();
  move_by(0, 100);
  wait_idle();
  EXPECT_EQ(unsolicited(), "");
}

TEST_F(VxmDriverTalk, EchoIsNotLeftOn) {
  start();
  EXPECT_EQ(send("E"), "");
  run(1);
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(query("X"), "+0000000");
}

TEST_F(VxmDriverTalk, LocalModeIsRespectedUntilSomethingIsWanted) {
  start();
  EXPECT_EQ(send("Q"), "");
  run(2);
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_THAT(std::string(latest.notice.view()), HasSubstr("Local mode"));
  EXPECT_EQ(move_by(0, 10), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 10);
}

TEST_F(VxmDriverTalk, CommandsThatARunningMoveWouldSwallowAreRefused) {
  start();
  move_by(0, 4000);
  EXPECT_EQ(
      send("PM2"),
      "A move from the console is under way, and the controller does not accept PM2 during it. Nothing was "
      "sent. Wait until the move ends, or stop it.");
  EXPECT_EQ(send("!"), "");
  EXPECT_TRUE(wait_idle());
}

}  // namespace
}  // namespace hw::vxm
