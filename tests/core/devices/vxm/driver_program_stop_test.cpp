// Stops of the user's stored programs.
#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;

class VxmProgramStop : public DriverTest {
 protected:
  void run_program(const char* text) {
    ASSERT_EQ(perform(intent::LoadProgram(0, text)), "");
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(0.5);
    sent();
  }
};

TEST_F(VxmProgramStop, ALongTextIsNotWaitedFor) {
  start({}, true);
  run_program("I1M4000\nI1M-4000\nL0\n");
  sent();
  std::string text;
  for (int i = 0; i < 300; ++i) text += "I1M400,";
  post(intent::SendText(text));
  run(0.1);
  post(intent::Stop());
  run(0.06);
  EXPECT_THAT(sent(), HasSubstr("H"));
}

TEST_F(VxmProgramStop, AStoredProgramComesToRestAndStaysThere) {
  start();
  run_program("I1M3000\nI2M3000\nI1M-3000\nL0\n");
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(sent(), "HDK") << "hold, ramp down, and K once it stands";
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_TRUE(stands(0));
  EXPECT_TRUE(stands(1));
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  run(1);
  EXPECT_TRUE(latest.any_axis_moving()) << "no hold is left behind";
}

TEST_F(VxmProgramStop, AProgramThatWaitsIsEndedToo) {
  start();
  run_program("U0\nI1M400\n");
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_EQ(perform(intent::HaltProgram()), "");
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_EQ(query("V"), "R");
  EXPECT_EQ(position(), 0);
}

TEST_F(VxmProgramStop, AHeldProgramIsKilledWhereItStands) {
  start();
  run_program("I1M100\nI1M100\nI1M100\n");
  wait_idle();
  EXPECT_EQ(perform(intent::SingleStep()), "");
  run(0.2);
  EXPECT_EQ(latest.program.run, RunState::held);
  sent();
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(sent(), "K");
  EXPECT_EQ(latest.program.run, RunState::idle);
}

TEST_F(VxmProgramStop, ASecondStopDuringAProgramNeedsNoRamp) {
  start();
  run_program("S1M4000\nA1M1\nI1M90000\n");
  run(5);
  sent();
  pump->post(Intent(++last_id, intent::Stop()));
  run(0.1);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_TRUE(wait_idle(1));
  EXPECT_TRUE(latest.axes[0].trust.doubtful());
  run(6);
  EXPECT_EQ(query("V"), "R");
}

// A stop of one axis, and of all a moment later, are two stops and no escalation.
TEST_F(VxmProgramStop, BesideTheStopOfOneAxisThatOfAllStillRamps) {
  start();
  run_program("S1M4800\nA1M2\nI1M90000\nI1M-90000\n");
  run(4);
  sent();
  const IntentId one = post(intent::Stop(0));
  run(0.1);
  const IntentId all = post(intent::Stop());
  EXPECT_TRUE(wait_idle());
  const std::string what = sent();
  EXPECT_EQ(std::count(what.begin(), what.end(), 'H'), 1) << what << ": a second H would let it go on";
  EXPECT_THAT(what, testing::EndsWith("K"));
  EXPECT_EQ(outcome(one), IntentState::done);
  EXPECT_EQ(outcome(all), IntentState::done);
  EXPECT_EQ(latest.program.ended_by, EndedBy::stop);
  EXPECT_FALSE(latest.axes[0].trust.doubtful()) << all_notices();
  EXPECT_TRUE(stands());
}

TEST_F(VxmProgramStop, WhileItStopsNothingButTheStateIsAskedOften) {
  start();
  run_program("I1M9000\nL0\n");
  loop->to_controller.clear();
  const IntentId stop = post(intent::Stop());
  ASSERT_TRUE(run_until([&] { return outcome(stop) != IntentState::pending; }));
  EXPECT_THAT(loop->to_controller, testing::MatchesRegex("HD[VXY]+([?~$@][VXY]+)*K[VXY]+"));
}

TEST_F(VxmProgramStop, ADForAProgramThatDidNotGetThroughIsSentAgain) {
  start();
  run_program("I1M90000\nI1M-90000\nL0\n");
  run(3);
  const auto when_asked = position();
  post(intent::Stop());
  run(0.0005);
  ASSERT_EQ(sent(), "H");
  loop->lose(1);
  EXPECT_TRUE(wait_idle(5));
  EXPECT_EQ(sent(), "DDK");
  EXPECT_LT(position(), when_asked + 3000);
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
}

// D has ended its last index: it has come to its end by itself, and its hold is taken off again.
TEST_F(VxmProgramStop, InItsLastIndexItEndsByItself) {
  start();
  run_program("I1M90000\n");
  run(2);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(latest.program.ended_by, EndedBy::stop);
  EXPECT_EQ(send("R"), "") << "not the console's own run";
  EXPECT_EQ(sent(), "HDHR");
  run(1);
  EXPECT_TRUE(latest.any_axis_moving());
}

// D ends an index, and the program goes on with the next.
TEST_F(VxmProgramStop, AnHThatDidNotGetThroughIsSentAgain) {
  start();
  run_program("I1M90000\nI1M-90000\nL0\n");
  run(3);
  const auto when_asked = position();
  loop->lose(1);
  post(intent::Stop());
  EXPECT_TRUE(wait_idle(5));
  EXPECT_THAT(sent(), testing::MatchesRegex("HD+HD+K"));
  EXPECT_NEAR(position(), when_asked, 3000);
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
}

TEST_F(VxmProgramStop, AKWhoseAnswerIsLostIsSentAgain) {
  start();
  run_program("I1M9000\nI1M-9000\nL0\n");
  EXPECT_EQ(perform(intent::Pause()), "");
  run(0.002);
  sent();
  loop->drop(1);
  EXPECT_EQ(perform(intent::Abort()), "");
  EXPECT_EQ(sent(), "KK");
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_EQ(latest.program.ended_by, EndedBy::abort);
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  EXPECT_EQ(sent(), "PM0\rPM\rR") << "no hold is left";
  run(1);
  EXPECT_TRUE(latest.any_axis_moving());
}

// V tells that nothing runs; of the hold nothing tells.
TEST_F(VxmProgramStop, ATypedKWhoseAnswerIsLostLeavesNoHoldBehind) {
  start();
  run_program("I1M9000\nI1M-9000\nL0\n");
  EXPECT_EQ(perform(intent::Pause()), "");
  run(0.002);
  loop->drop(1);
  EXPECT_THAT(query("K"), HasSubstr("did not answer"));
  EXPECT_TRUE(wait_idle(2));
  EXPECT_EQ(latest.program.run, RunState::idle) << "V says so";
  EXPECT_EQ(latest.program.ended_by, EndedBy::abort);
  sent();
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  EXPECT_EQ(sent(), "KPM0\rPM\rR") << "an H would switch the hold on";
  run(1);
  EXPECT_TRUE(latest.any_axis_moving());
  EXPECT_EQ(latest.program.run, RunState::running);
}

TEST_F(VxmProgramStop, AProgramStartedByTheRunButtonIsStoppedBeforeAnyPollSawIt) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M30000\nI1M-30000\nL0\n")), "");
  run(0.25);
  ASSERT_TRUE(loop->operate(bench::Button("Run", true)));
  run(0.01);
  ASSERT_TRUE(loop->operate(bench::Button("Run", false)));
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_TRUE(stands());
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmProgramStop, WithTheOverrunHazardNothingLocksTheController) {
  start({{"quirk", "overrun"}});
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M3000\nU4\nP1\nI1M-3000\nL0\n")), "");
  for (int round = 0; round < 3; ++round) {
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(0.7 + 0.1 * round);
    ASSERT_EQ(perform(intent::Stop()), "");
    ASSERT_EQ(move_by(0, 500), "");
    run(0.3);
    ASSERT_EQ(perform(intent::Stop()), "");
    wait_idle();
    ASSERT_EQ(perform(intent::Stop()), "");
    ASSERT_EQ(perform(intent::SetOutput(1, round % 2 == 0)), "");
    ASSERT_EQ(perform(intent::ReadParams()), "");
    ASSERT_EQ(perform(intent::SingleStep()), "");
    run(0.2);
    ASSERT_EQ(perform(intent::Stop()), "");
  }
  send("Q");
  run(0.5);
  perform(intent::Stop());
  run(0.5);
  EXPECT_EQ(query("V"), "R");
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(latest.link.timeouts, 0u);
}

}  // namespace
}  // namespace hw::vxm
