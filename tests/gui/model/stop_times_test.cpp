// How long stops took, as a hand reads it.
#include "gui/model/stop_times.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

std::string in_steps(AxisId, Steps place) { return std::to_string(place.value) + " steps"; }

Ending stop(int axis, Duration to_rest, std::int64_t on) {
  Ending e;
  e.axis = axis;
  e.timed = true;
  e.to_wire = std::chrono::microseconds(200);
  e.to_rest = to_rest;
  e.ran_on = Steps(on);
  return e;
}

TEST(StopTimes, ShowTheLastOneAndWhatAlmostAllKeep) {
  StopTimes times;
  EXPECT_EQ(times.words(), "");
  times.add(stop(0, Millis(84), 680), in_steps);
  EXPECT_EQ(times.words(),
            "Last stop: first byte after 0.2 ms, slowing down not seen, at rest after 84 ms, 680 steps on.");
  for (int i = 0; i < 99; ++i)
    times.add(stop(i % 2, Millis(i == 50 ? 500 : 100), i % 2 == 0 ? 7 : 900), in_steps);
  EXPECT_EQ(times.words(),
            "Last stop: first byte after 0.2 ms, slowing down not seen, at rest after 100 ms, 7 steps on. In "
            "99 of 100 of the last 100 stops the first byte went out within 0.2 ms and the axis was at rest "
            "within 100 ms and 680 steps.");
}

TEST(StopTimes, DescribeTheStopButtonToo) {
  StopTimes times;
  EXPECT_EQ(times.tip(),
            "Stops this controller with its ramp. Again, or Shift Esc: at once, without a ramp.");
  times.add(stop(0, Millis(84), 680), in_steps);
  EXPECT_TRUE(times.tip().starts_with("Stops this controller with its ramp. Again, or Shift Esc: at once"));
  EXPECT_TRUE(times.tip().ends_with(times.words()));
}

TEST(StopTimes, EachFigureHasItsPercentile) {
  StopTimes times;
  for (int i = 0; i < 100; ++i) {
    Ending one = stop(0, Millis(100), 10);
    one.to_wire = i == 7 ? Millis(9) : i == 8 ? Millis(3) : Millis(1);
    one.to_slowing = i == 7 ? Millis(90) : Millis(30);
    times.add(one, in_steps);
  }
  EXPECT_TRUE(times.words().ends_with(
      "In 99 of 100 of the last 100 stops the first byte went out within 3.0 ms, slowing "
      "down was seen within 30 ms and the axis was at rest within 100 ms and 10 steps."))
      << times.words();
}

TEST(StopTimes, IfTheControllerReportsItSlowingDownIsAFigureOfItsOwn) {
  StopTimes times;
  Ending seen = stop(0, Millis(84), 680);
  seen.to_slowing = Millis(31);
  times.add(seen, in_steps);
  EXPECT_EQ(
      times.words(),
      "Last stop: first byte after 0.2 ms, slowing down seen after 31 ms, at rest after 84 ms, 680 steps "
      "on.");
}

TEST(StopTimes, AnUntimedStopIsLeftOut) {
  StopTimes times;
  Ending untimed = stop(0, Millis(84), 680);
  untimed.timed = false;
  times.add(untimed, in_steps);
  EXPECT_EQ(times.words(), "");
}

}  // namespace
}  // namespace hw::gui
