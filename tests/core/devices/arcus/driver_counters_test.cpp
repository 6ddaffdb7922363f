// Counters that somebody sets, moves that somebody else cuts short: what the console makes of positions that
// are not where it sent the axis.
#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

constexpr std::string_view four_axes = "pmx-4ex-sa", closed_loop = "dmx-k-sa";

class Counters : public DriverTest {
 protected:
  void move_to(std::int64_t target) {
    ASSERT_EQ(perform(intent::MoveTo(targets({target}))), "");
    ASSERT_TRUE(wait_idle());
    ASSERT_EQ(position(), target);
  }
  void send(std::string text) {
    ASSERT_EQ(perform(intent::SendText(std::move(text))), "");
    run(5);
  }
  bool reports_switched_off() { return reported("switched off and on"); }
  /// Another program on the line; its answer is not ours.
  void another_sends(std::string_view bytes) {
    std::string answer;
    loop->emulator().receive(bytes);
    loop->emulator().take_output(answer);
  }
};

// With StepNLoop both counters are written (decision AMB-039).
TEST_F(Counters, SetByTheUsersOwnTextNoPowerCycleIsReported) {
  start(closed_loop);
  ASSERT_EQ(perform(intent::SetParam("SLT", 30)), "");
  move_to(500);
  send("PX=0");
  EXPECT_EQ(position(), 0);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
  EXPECT_TRUE(latest.unsaved_setup) << "SLT was not stored";
  move_to(500);
  ASSERT_TRUE(loop->operate(bench::PowerCycle()));
  run(40);
  EXPECT_TRUE(reports_switched_off()) << "a real one still is";
}

TEST_F(Counters, AnEncoderCounterThatTakesThePositionAlong) {
  start(four_axes);
  ASSERT_EQ(perform(intent::SetParam("SLX", 1)), "");
  move_to(500);
  send("EX=0");
  EXPECT_EQ(position(), 0);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

TEST_F(Counters, ByAQuestionOfAScript) {
  start(closed_loop);
  move_to(500);
  EXPECT_EQ(query("PX=0"), "OK");
  EXPECT_EQ(query("EX=0"), "OK");
  run(5);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

// The load has never moved, so the target goes back to zero (decision AMB-040).
TEST_F(Counters, ByClearingAStall) {
  start(closed_loop);
  ASSERT_TRUE(loop->operate(bench::Jam(AxisId{0}, true)));
  ASSERT_EQ(perform(intent::MoveTo(targets({20000}))), "");
  run(20);
  ASSERT_EQ(latest.axes[0].activity, Activity::error);
  ASSERT_GT(position(), 500);
  EXPECT_EQ(latest.axes[0].trust.cause, Doubt::slipped) << "its steps were lost";
  send("CLR");
  EXPECT_EQ(position(), 0);
  EXPECT_TRUE(latest.axes[0].trust.doubtful()) << "until it is homed, or somebody says where it stands";
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

// 10 counts at 100 a second take less than the time between two rounds at rest.
TEST_F(Counters, AShortMoveToZeroByTheUsersOwnTextIsNoPowerCycle) {
  start(closed_loop);
  move_to(10);
  run(3);
  EXPECT_EQ(query("X0"), "OK");
  run(5);
  EXPECT_EQ(position(), 0);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

// ---- cut short

TEST_F(Counters, AMoveThatAnotherProgramStopsHasNotComeToItsTarget) {
  for (const std::string_view model : {four_axes, closed_loop}) {
    start(model);
    ASSERT_EQ(perform(intent::MoveBy(targets({3000}))), "");
    run(1);
    ASSERT_EQ(latest.axes[0].activity, Activity::moving);
    another_sends(model == four_axes ? "@00STOPX\r" : "@00STOP\r");
    ASSERT_TRUE(wait_idle());
    EXPECT_LT(position(), 3000);
    EXPECT_EQ(latest.axes[0].ended_by, EndedBy::elsewhere) << model << " at " << position();
    TearDown();
    latest = Snapshot();
  }
}

TEST_F(Counters, AMoveThatTheUsersOwnTextStopsWasStoppedByTheConsole) {
  for (const auto& [text, why] : {std::pair("STOP", EndedBy::stop), std::pair("ABORT", EndedBy::abort)}) {
    start(closed_loop);
    ASSERT_EQ(perform(intent::MoveBy(targets({3000}))), "");
    run(1);
    EXPECT_EQ(query(text), "OK");
    ASSERT_TRUE(wait_idle());
    EXPECT_LT(position(), 3000);
    EXPECT_EQ(latest.axes[0].ended_by, why) << text;
    TearDown();
    latest = Snapshot();
  }
}

TEST_F(Counters, AxesOnAStraightLineEndTogether) {
  start(four_axes);
  ASSERT_EQ(perform(intent::MoveTo(targets({3000, 3000}))), "");
  run(1);
  ASSERT_EQ(perform(intent::Stop(0)), "");
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::stop);
  EXPECT_EQ(latest.axes[1].ended_by, EndedBy::stop) << "by the same stop";
  ASSERT_EQ(perform(intent::MoveTo(targets({9000, 9000}))), "");
  run(1);
  ASSERT_TRUE(loop->operate(bench::Limit(AxisId{1}, Sign::plus, true)));
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(latest.axes[1].ended_by, EndedBy::limit);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::nothing) << "not at its target, and nobody else has stopped it";
}

TEST_F(Counters, AMoveToZeroBetweenTwoRoundsIsNoPowerCycle) {
  for (const std::string_view model : {four_axes, closed_loop}) {
    start(model);
    for (const std::int64_t from : {13, -7, 100}) {
      move_to(from);
      move_to(0);
      EXPECT_FALSE(reports_switched_off()) << model << " from " << from;
    }
  }
}

TEST_F(Counters, AMoveThatComesToItsTargetIsReportedAsArrived) {
  for (const std::string_view model : {four_axes, closed_loop}) {
    start(model);
    move_to(3000);
    EXPECT_EQ(latest.axes[0].ended_by, EndedBy::target);
    ASSERT_EQ(perform(intent::MoveBy(targets({-500}))), "");
    run(0.5);
    EXPECT_NE(perform(intent::MoveTo(targets({7000}))), "") << "refused while it moves";
    ASSERT_TRUE(wait_idle());
    EXPECT_EQ(position(), 2500);
    EXPECT_EQ(latest.axes[0].ended_by, EndedBy::target) << "the refused target does not count";
    ASSERT_EQ(perform(intent::MoveTo(targets({6000}))), "");
    run(0.5);
    EXPECT_EQ(query(model == four_axes ? "TX4000" : "T4000"), "OK") << "the user's own change of target";
    ASSERT_TRUE(wait_idle());
    EXPECT_EQ(position(), 4000);
    EXPECT_EQ(latest.axes[0].ended_by, EndedBy::target);
    TearDown();
    latest = Snapshot();
  }
}

}  // namespace
}  // namespace hw::arcus
