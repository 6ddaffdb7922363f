// The steps that a motion takes in the snapshot, whichever controller makes it.
#include "core/device/axis_motion.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

AxisState moving() {
  AxisState axis;
  begin_motion(axis, Activity::jogging);
  axis.phase = Phase::accelerating, axis.direction = -1, axis.ramp = 500;
  return axis;
}

TEST(AxisMotion, ABeginForgetsHowTheLastOneEnded) {
  AxisState axis;
  axis.ended_by = EndedBy::limit, axis.has_target = true;
  begin_motion(axis, Activity::homing);
  EXPECT_EQ(axis.ended_by, EndedBy::nothing);
  EXPECT_EQ(axis.activity, Activity::homing);
  EXPECT_FALSE(axis.has_target) << "it is that of the motion before";
  begin_motion(axis, Activity::moving, Steps(-40));
  EXPECT_EQ(axis.goal(), Steps(-40));
}

TEST(AxisMotion, OnlyWhatMovesIsShownAsStopping) {
  AxisState axis = moving();
  stop_motion(axis);
  EXPECT_EQ(axis.activity, Activity::stopping);
  for (const Activity still : {Activity::unknown, Activity::idle, Activity::error}) {
    axis.activity = still;
    stop_motion(axis);
    EXPECT_EQ(axis.activity, still);
  }
}

TEST(AxisMotion, AtRestNothingIsLeftOfTheMotionButItsEnd) {
  AxisState axis = moving(), rests;
  axis.has_target = true;
  end_motion(axis, EndedBy::stop);
  rests.activity = Activity::idle, rests.ended_by = EndedBy::stop;
  EXPECT_EQ(axis, rests);
}

TEST(AxisMotion, ALostOneIsNeitherMovingNorAtRest) {
  AxisState axis = moving();
  lose_motion(axis);
  EXPECT_EQ(axis.ended_by, EndedBy::lost);
  EXPECT_EQ(axis.activity, Activity::unknown);
  EXPECT_EQ(axis.direction, 0);
  EXPECT_EQ(axis.ramp, 0) << "a way to rest would be guessed";
  axis.activity = Activity::idle, axis.ended_by = EndedBy::target;
  lose_motion(axis);
  EXPECT_EQ(axis.ended_by, EndedBy::target) << "it rested when it was lost";
}

TEST(AxisMotion, AStopAtOnceIsNotTakenBackByOneWithARamp) {
  EXPECT_EQ(ended_by_stop(EndedBy::nothing, false), EndedBy::stop);
  EXPECT_EQ(ended_by_stop(EndedBy::stop, true), EndedBy::abort);
  EXPECT_EQ(ended_by_stop(EndedBy::abort, false), EndedBy::abort);
}

TEST(AxisMotion, AStopIsOverAtRestAndFailsAfterHalfAMinute) {
  using Now = StopProgress::Now;
  EXPECT_EQ(progress_of_stop(true, std::chrono::seconds(30)).now, Now::wait);
  EXPECT_EQ(progress_of_stop(true, std::chrono::seconds(31)).now, Now::failed);
  EXPECT_EQ(progress_of_stop(false, std::chrono::seconds(31)).now, Now::stands);
}

TEST(AxisMotion, AMotorThatCouldNotStopInStepIsDoubted) {
  AxisState axis = moving();
  axis.trust.settle(Trust::homed, Instant(Millis(1)));
  Kill kill{
      .axis = "Axis X", .speed = 400, .safe = 400, .unit = "steps/s", .safe_word = "its low speed, 400"};
  EXPECT_EQ(doubt_killed(axis, kill, Instant(Millis(5))), "");
  EXPECT_FALSE(axis.trust.doubtful());
  kill.speed = 400.6;
  EXPECT_EQ(doubt_killed(axis, kill, Instant(Millis(5))),
            "Axis X may have lost steps: it was stopped without a ramp at 401 steps/s, above its low speed, "
            "400. Its position cannot be trusted until it is homed or set.");
  EXPECT_EQ(axis.trust.cause, Doubt::killed);
}

}  // namespace
}  // namespace hw
