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

TEST(StopTimes, TellTheLastOneAndWhatAlmostAllKeep) {
  StopTimes times;
  EXPECT_EQ(times.words(), "");
  times.add(stop(0, Millis(84), 680), in_steps);
  EXPECT_EQ(times.words(), "Last stop: first byte after 0.2 ms, at rest after 84 ms, 680 steps on.");
  for (int i = 0; i < 99; ++i)
    times.add(stop(i % 2, Millis(i == 50 ? 500 : 100), i % 2 == 0 ? 7 : 900), in_steps);
  EXPECT_EQ(
      times.words(),
      "Last stop: first byte after 0.2 ms, at rest after 100 ms, 7 steps on. Of 100 stops 99 in 100 were "
      "at rest within 100 ms and 680 steps.");
}

TEST(StopTimes, WhereTheControllerTellsItSlowingDownIsAFigureOfItsOwn) {
  StopTimes times;
  Ending seen = stop(0, Millis(84), 680);
  seen.to_slowing = Millis(31);
  times.add(seen, in_steps);
  EXPECT_EQ(
      times.words(),
      "Last stop: first byte after 0.2 ms, slowing down seen after 31 ms, at rest after 84 ms, 680 steps "
      "on.");
}

TEST(StopTimes, WhatNobodyHasTimedIsNoneOfThem) {
  StopTimes times;
  Ending untimed = stop(0, Millis(84), 680);
  untimed.timed = false;
  times.add(untimed, in_steps);
  EXPECT_EQ(times.words(), "");
}

}  // namespace
}  // namespace hw::gui
