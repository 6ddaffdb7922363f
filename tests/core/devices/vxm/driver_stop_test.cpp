#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;

class VxmDriverStop : public DriverTest {
 protected:
  void run_program(const char* text) {
    ASSERT_EQ(perform(intent::LoadProgram(0, text)), "");
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(0.5);
    sent();
  }
  bool stands(int axis = 0) {
    run(0.3);
    const auto here = position(axis);
    run(2);
    return position(axis) == here;
  }
};

TEST_F(VxmDriverStop, AMoveOfTheConsoleIsRampedDownByDAlone) {
  start();
  move_to(0, 20000);
  run(2);
  sent();
  const IntentId stop = post(intent::Stop());
  run(0.1);
  EXPECT_EQ(latest.axes[0].activity, Activity::stopping);
  EXPECT_EQ(fate(stop), Fate::pending) << "it still turns";
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(fate(stop), Fate::done);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::stop);
  EXPECT_EQ(sent(), "D");
  EXPECT_TRUE(stands());
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
}

TEST_F(VxmDriverStop, ADThatDidNotGetThroughIsSaidAgain) {
  start();
  move_to(0, 50000);
  run(3);
  sent();
  post(intent::Stop());
  loop->lose(1);
  run(0.05);
  const auto when_asked = position();
  EXPECT_TRUE(wait_idle(5));
  EXPECT_EQ(sent(), "DD");
  EXPECT_LT(position(), when_asked + 3000);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::stop);
}

TEST_F(VxmDriverStop, TypedItEndsTheWholeMove) {
  start();
  std::vector<AxisTarget> both = target(0, 8000);
  both.push_back(target(1, 8000)[0]);
  EXPECT_EQ(perform(intent::MoveTo(both)), "");
  run(1);
  EXPECT_EQ(perform(intent::SendText("D")), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_TRUE(stands(0));
  EXPECT_EQ(position(1), 0);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::stop);
}

TEST_F(VxmDriverStop, ATypedKWaitsForNoRamp) {
  start();
  move_to(0, 50000);
  run(3);
  sent();
  post(intent::Stop());
  run(0.05);
  post(intent::SendText("K"));
  run(0.05);
  EXPECT_EQ(sent(), "DK");
}

TEST_F(VxmDriverStop, ALongTextIsNotWaitedFor) {
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

// At each moment of a move's end, also while its last questions are on the wire.
TEST_F(VxmDriverStop, AtTheVeryEndOfAMoveDoesNoHarm) {
  start({}, true);
  for (int ms = 0; ms < 60; ++ms) {
    move_to(0, ms % 2 == 0 ? 100 : 0);
    run(0.40 + ms * 0.001);
    EXPECT_EQ(perform(intent::Stop()), "") << ms;
    EXPECT_TRUE(wait_idle(5)) << ms;
  }
}

TEST_F(VxmDriverStop, AMoveThatEndedBeforeItsStopHasArrived) {
  start();
  move_to(0, 4000);
  ASSERT_TRUE(run_until([&] { return position() > 3900; }));
  loop->lose(1);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 4000);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::target);
}

TEST_F(VxmDriverStop, AnAxisThatWasToMoveWithAnotherNeverStarts) {
  start({{"motors", "4"}});
  std::vector<AxisTarget> three = target(0, 4000);
  three.push_back(target(1, 400)[0]);
  three.push_back(target(2, 4000)[0]);
  EXPECT_EQ(perform(intent::MoveBy(three)), "");
  run(0.5);
  EXPECT_EQ(perform(intent::Stop(2)), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(2), 0);
  EXPECT_EQ(position(0), 4000) << "it was not asked to stop";
}

TEST_F(VxmDriverStop, TheOtherAxisOfAMoveNeverStarts) {
  start();
  std::vector<AxisTarget> both = target(0, 8000);
  both.push_back(target(1, 8000)[0]);
  EXPECT_EQ(perform(intent::MoveTo(both)), "");
  run(1);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_TRUE(stands(0));
  EXPECT_EQ(position(1), 0);
}

TEST_F(VxmDriverStop, AStoredProgramComesToRestAndStaysThere) {
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

TEST_F(VxmDriverStop, AProgramThatWaitsIsEndedToo) {
  start();
  run_program("U0\nI1M400\n");
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_EQ(perform(intent::HaltProgram()), "");
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_EQ(query("V"), "R");
  EXPECT_EQ(position(), 0);
}

TEST_F(VxmDriverStop, AHeldProgramIsKilledWhereItStands) {
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

TEST_F(VxmDriverStop, ASecondStopIsKAtOnceAndDoubtsAFastPosition) {
  start();
  move_to(0, 50000);
  run(3);
  sent();
  post(intent::Stop());
  run(0.05);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(sent(), "DK");
  EXPECT_TRUE(wait_idle());
  EXPECT_TRUE(latest.axes[0].trust.doubtful());
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::abort);
  EXPECT_TRUE(
      told("Motor 1 was stopped without a ramp at about 2000 steps/s. Above 1000 steps/s it may have lost "
           "steps: its "
           "position is doubtful until it is homed or set to zero."))
      << all_notices();
  EXPECT_EQ(perform(intent::SetPosition(0)), "");
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
}

TEST_F(VxmDriverStop, ASecondStopDuringAProgramNeedsNoRamp) {
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

TEST_F(VxmDriverStop, AbortOfASlowMoveLosesNothing) {
  start();
  move_to(0, 5000, 800);
  run(2);
  EXPECT_EQ(perform(intent::Abort()), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
  EXPECT_TRUE(stands());
  sent();
  EXPECT_EQ(move_by(0, 10), "");
  EXPECT_THAT(sent(), HasSubstr("S1M2000\rI1M10\r")) << "the speed of the move that was cut off is put right";
}

TEST_F(VxmDriverStop, AProgramStartedByTheRunButtonIsStoppedBeforeAnyPollSawIt) {
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

TEST_F(VxmDriverStop, SomebodyWhoJogsAtThePanelIsStopped) {
  start();
  EXPECT_EQ(send("Q"), "");
  ASSERT_TRUE(loop->operate(bench::Button("1+", true)));
  run(1.5);
  EXPECT_EQ(latest.axes[0].activity, Activity::jogging);
  sent();
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(sent(), "FK");
  EXPECT_TRUE(stands());
}

TEST_F(VxmDriverStop, AtRestItSendsDAndNothingElse) {
  start();
  sent();
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(sent(), "D");
}

TEST_F(VxmDriverStop, StopOvertakesADownload) {
  start({}, true);
  std::string text;
  for (int i = 0; i < 60; ++i) text += "I1M400\n";
  const IntentId load = ++last_id;
  pump->post(Intent(load, intent::LoadProgram(1, text)));
  run(0.1);
  EXPECT_EQ(perform(intent::Stop()), "");
  run(0.5);
  EXPECT_EQ(fate(load), Fate::failed);
  EXPECT_THAT(std::string(pump->known().fate_of(load)->sentence.view()),
              HasSubstr("Program 1 is incomplete in the controller. Load it again before it is run."));
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmDriverStop, WithTheOverrunHazardNothingLocksTheController) {
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
