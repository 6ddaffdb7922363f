#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class VxmDriverStop : public DriverTest {};

TEST_F(VxmDriverStop, AMoveOfTheConsoleIsRampedDownByDAlone) {
  start();
  move_to(0, 20000);
  run(2);
  sent();
  const IntentId stop = post(intent::Stop());
  run(0.1);
  EXPECT_EQ(latest.axes[0].activity, Activity::stopping);
  EXPECT_EQ(outcome(stop), IntentState::pending) << "it still turns";
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(outcome(stop), IntentState::done);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::stop);
  EXPECT_EQ(sent(), "D");
  EXPECT_TRUE(stands());
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
}

TEST_F(VxmDriverStop, ADThatDidNotGetThroughIsSentAgain) {
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
      reported("Motor 1 may have lost steps: it was stopped without a ramp at about 2000 steps/s, above "
               "1000. Its position cannot be trusted until it is homed or set to zero."))
      << all_notices();
  EXPECT_EQ(perform(intent::SetPosition(0)), "");
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
}

TEST_F(VxmDriverStop, AnUnconfirmedKIsSentAgain) {
  start();
  move_to(0, 50000);
  run(3);
  sent();
  loop->lose(1);
  const IntentId abort = post(intent::Abort());
  EXPECT_TRUE(wait_idle(2));
  EXPECT_EQ(sent(), "KK");
  EXPECT_EQ(outcome(abort), IntentState::done);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::abort);
}

TEST_F(VxmDriverStop, AnUnexpectedWOrColonLeavesNothingWaitingOrHeld) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M100\nI1M100\n")), "");
  for (const char* unexpected : {"W", ":I1M400\r"}) {
    loop->inject(unexpected);
    run(1);
    EXPECT_EQ(latest.program.run, RunState::idle) << unexpected;
    EXPECT_EQ(perform(intent::RunProgram(0)), "") << unexpected;
    EXPECT_TRUE(wait_idle(5)) << unexpected;
  }
  EXPECT_EQ(position(), 400) << "no hold was switched on";
}

// The console has selected another program for its own use.
TEST_F(VxmDriverStop, TheUsersProgramIsSelectedAgainBehindAStop) {
  start({}, true);
  std::string text;
  for (int i = 0; i < 60; ++i) text += "I1M400\n";
  for (const auto& long_one : {IntentBody(intent::LoadProgram(3, text)), IntentBody(intent::UploadProgram(3)),
                               IntentBody(intent::ReadAgain())}) {
    post(long_one);
    run(0.05);
    EXPECT_EQ(perform(intent::Stop()), "");
    EXPECT_EQ(query("PM"), "0");
    EXPECT_EQ(latest.program.slot, 0);
  }
}

// At the old rate nobody would hear it.
TEST_F(VxmDriverStop, WaitsForAChangeOfTheLineRate) {
  start({}, true);
  const IntentId change = post(intent::SetParam("B", 38, true));
  run(0.02);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(outcome(change), IntentState::done);
  EXPECT_EQ(latest.link.state, LinkState::good);
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

TEST_F(VxmDriverStop, AJogAtThePanelIsStopped) {
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
  EXPECT_EQ(outcome(load), IntentState::failed);
  EXPECT_THAT(
      std::string(pump->known().outcome_of(load)->sentence.view()),
      MatchesRegex(".*Program 1 is incomplete in the controller: the first [0-9]+ of its 60 lines are "
                   "written. Load it again before it is run."));
  EXPECT_FALSE(latest.transfer.running);
  EXPECT_EQ(query("V"), "R");
}

}  // namespace
}  // namespace hw::vxm
