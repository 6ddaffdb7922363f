// What a driver knows of the motion of each axis: how it began, how it ended, how far a stop has come.
#include "core/device/axis_tracking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/stopping_way.h"
#include "core/time/virtual_scheduler.h"

namespace hw {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class AxisTrackingTest : public testing::Test {
 protected:
  AxisTrackingTest() {
    catalog.axes = {{"A", ""}, {"B", ""}};
    snapshot.axis_count = 2;
    read(0, false);
    read(1, false, 0, 1);
  }
  /// A reading that was asked for now.
  void read(std::int64_t position, bool moves, double speed = 0, int axis = 0) {
    reading.position = Steps(position), reading.moves = moves, reading.speed = Pps(speed);
    tracking.read(axis, reading, time.now());
  }
  void pass(double s) { time.run_for(from_seconds(s)); }
  AxisState& a() { return snapshot.axes[0]; }
  [[nodiscard]] StopProgress::Now progress(int axis = -1) const {
    StopOrder order;
    order.axis = axis;
    order.sent_at = sent_at, order.first_sent_at = sent_at;
    return tracking.progress(order).now;
  }
  void stop(int axis, bool at_once) {
    pass(0.1);
    sent_at = time.now();
    tracking.stopping(axis, at_once);
    pass(0.1);
  }

  IoContext io;
  VirtualScheduler time{io};
  Catalog catalog;
  Snapshot snapshot;
  ScriptTexts texts;
  std::vector<std::string> reported;
  DriverContext context{
      time, catalog, snapshot, texts, [this](const Notice& n) { reported.push_back(n.text); }, [] {}};
  AxisTracking tracking{context, Pps(400)};
  AxisTracking::Reading reading;
  Instant sent_at{};
};

TEST_F(AxisTrackingTest, AMoveEndsAtItsTarget) {
  tracking.begun(0, {Activity::moving, Steps(-300)});
  EXPECT_EQ(a().activity, Activity::moving);
  EXPECT_EQ(a().goal(), Steps(-300));
  EXPECT_EQ(a().direction, -1);
  read(-100, true, 1000);
  EXPECT_EQ(a().activity, Activity::moving);
  read(-300, false);
  EXPECT_EQ(a().activity, Activity::idle);
  EXPECT_EQ(a().ended_by, EndedBy::target);
  EXPECT_FALSE(a().has_target);
}

// The answer was on its way when the motion began: "at rest" is of the time before.
TEST_F(AxisTrackingTest, AnAnswerToAnEarlierQuestionDoesNotEndIt) {
  const Instant asked_before = time.now();
  pass(0.1);
  tracking.begun(0, {Activity::moving, Steps(300)});
  reading.moves = false;
  tracking.read(0, reading, asked_before);
  EXPECT_EQ(a().activity, Activity::moving);
  EXPECT_EQ(a().ended_by, EndedBy::nothing);
}

TEST_F(AxisTrackingTest, AMoveShortOfItsTargetEndedAtALimitOrElsewhere) {
  tracking.begun(0, {Activity::moving, Steps(300)});
  reading.limit_minus = true;
  read(100, false);
  EXPECT_EQ(a().ended_by, EndedBy::elsewhere) << "the switch behind it did not end it";
  tracking.begun(0, {Activity::moving, Steps(300)});
  reading.limit_minus = false, reading.limit_plus = true;
  read(200, false);
  EXPECT_EQ(a().ended_by, EndedBy::limit);
  reading.limit_plus = false;
  tracking.begun(0, {Activity::jogging, {}, Sign::minus});
  EXPECT_EQ(a().direction, -1);
  reading.limit_minus = true;
  read(-900, false);
  EXPECT_EQ(a().ended_by, EndedBy::limit) << "a jog has no target";
}

TEST_F(AxisTrackingTest, AJogThatThisConsoleDidNotStopEndedElsewhere) {
  tracking.begun(0, {Activity::jogging, {}, Sign::plus});
  read(10, true, 1000);
  read(30, false);
  EXPECT_EQ(a().ended_by, EndedBy::elsewhere);
  tracking.begun(0, {Activity::jogging, Steps(60)});
  read(60, false);
  EXPECT_EQ(a().ended_by, EndedBy::target) << "it went to the user's limit";
}

TEST_F(AxisTrackingTest, HomingSetsTheCountOnlyWhereItFoundItsPlace) {
  reading.homed = false;
  tracking.begun(0, {Activity::homing, {}, Sign::minus});
  read(-20, true);
  EXPECT_EQ(a().activity, Activity::homing);
  read(-50, false);
  EXPECT_EQ(a().ended_by, EndedBy::elsewhere);
  EXPECT_EQ(a().trust.kind, Trust::counted);
  reading.homed = true;
  tracking.begun(0, {Activity::homing, {}, Sign::minus});
  read(0, false);
  EXPECT_EQ(a().ended_by, EndedBy::target);
  EXPECT_EQ(a().trust.kind, Trust::homed);
}

TEST_F(AxisTrackingTest, AStopIsSeenFirstAsStoppingThenAsTheEnd) {
  tracking.begun(0, {Activity::jogging, {}, Sign::plus});
  read(10, true, 1000);
  stop(0, false);
  EXPECT_EQ(a().activity, Activity::stopping);
  read(50, true, 300);
  EXPECT_EQ(a().activity, Activity::stopping);
  EXPECT_EQ(progress(0), StopProgress::Now::wait);
  read(60, false);
  EXPECT_EQ(a().ended_by, EndedBy::stop);
  EXPECT_EQ(progress(0), StopProgress::Now::stands);
  EXPECT_THAT(reported, IsEmpty());
  EXPECT_FALSE(a().trust.doubtful());
}

TEST_F(AxisTrackingTest, AStopStandsOnlyByAReadingThatWasAskedForBehindIt) {
  stop(-1, false);
  EXPECT_EQ(progress(), StopProgress::Now::wait) << "both were at rest before it was sent";
  read(0, false);
  EXPECT_EQ(progress(0), StopProgress::Now::stands);
  EXPECT_EQ(progress(), StopProgress::Now::wait) << "of B nothing is known since";
  read(0, false, 0, 1);
  EXPECT_EQ(progress(), StopProgress::Now::stands);
}

TEST_F(AxisTrackingTest, AStopThatDoesNotComeToRestFailsAfterHalfAMinute) {
  tracking.begun(0, {Activity::jogging, {}, Sign::plus});
  stop(0, false);
  pass(29), read(10, true, 1000);
  EXPECT_EQ(progress(0), StopProgress::Now::wait);
  pass(2), read(20, true, 1000);
  EXPECT_EQ(progress(0), StopProgress::Now::failed);
}

TEST_F(AxisTrackingTest, AStopWithoutARampMakesTheCountOfAFastAxisDoubtful) {
  tracking.begun(0, {Activity::jogging, {}, Sign::plus});
  read(10, true, 400);
  stop(0, true);
  EXPECT_FALSE(a().trust.doubtful()) << "it may start and stop at this speed";
  read(10, false);
  EXPECT_EQ(a().ended_by, EndedBy::abort);
  tracking.begun(0, {Activity::jogging, {}, Sign::plus});
  read(20, true, 401);
  stop(0, true);
  EXPECT_EQ(a().trust.cause, Doubt::killed);
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_THAT(reported[0], HasSubstr("Axis A may have lost steps: it was stopped without a ramp at 401 "));
  stop(0, true);
  EXPECT_EQ(reported.size(), 1u) << "it is told once";
}

TEST_F(AxisTrackingTest, AMotionBegunElsewhereIsShownAsAMove) {
  read(5, true, 100);
  read(-5, true, 100);
  EXPECT_EQ(a().activity, Activity::moving);
  read(-9, false);
  EXPECT_EQ(a().activity, Activity::idle);
  EXPECT_EQ(a().ended_by, EndedBy::target) << "nobody knows where it was to go";
}

TEST_F(AxisTrackingTest, ARestartMakesAllCountsDoubtfulAndReportsIt) {
  snapshot.params[3].known = true;
  tracking.begun(1, {Activity::moving, Steps(300)});
  tracking.restarted();
  EXPECT_EQ(snapshot.restarts, 1u);
  EXPECT_FALSE(snapshot.params[3].known);
  EXPECT_EQ(snapshot.axes[1].ended_by, EndedBy::lost);
  for (std::size_t i : {0, 1}) EXPECT_EQ(snapshot.axes[i].trust.cause, Doubt::power_cut);
  EXPECT_THAT(reported, testing::ElementsAre(HasSubstr("was switched off and on")));
  tracking.was_set(0);
  EXPECT_EQ(a().trust.kind, Trust::set);
}

TEST_F(AxisTrackingTest, WithoutAWireNothingIsKnown) {
  tracking.begun(0, {Activity::moving, Steps(300)});
  tracking.wire_lost();
  EXPECT_FALSE(a().position_known);
  EXPECT_EQ(a().activity, Activity::unknown);
  read(300, false);
  EXPECT_EQ(a().ended_by, EndedBy::lost) << "the motion from before is not taken up";
}

TEST_F(AxisTrackingTest, TheWayOfARampNeverExceedsTheWayThatItCameNorTheRest) {
  AxisState& axis = a();
  axis.ramp = 1000, axis.speed = Pps(1000), axis.began_at = Steps(0), axis.position = Steps(10'000);
  EXPECT_EQ(stopping_way_by_ramp(catalog, snapshot, AxisId{0}), 500);
  axis.position = Steps(100);
  EXPECT_EQ(stopping_way_by_ramp(catalog, snapshot, AxisId{0}), 100) << "it has not yet reached its speed";
  axis.position = Steps(10'000), axis.has_target = true, axis.target = Steps(10'040);
  EXPECT_EQ(stopping_way_by_ramp(catalog, snapshot, AxisId{0}), 40);
  axis.activity = Activity::stopping;
  EXPECT_EQ(stopping_way_by_ramp(catalog, snapshot, AxisId{0}), std::nullopt);
}

}  // namespace
}  // namespace hw
