// A move is checked before its driver sees it: axes, targets, speed and ramp.
#include "core/device/target_check.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/snapshot.h"

namespace hw {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class TargetCheck : public testing::Test {
 protected:
  TargetCheck() {
    catalog.axes = {{"A", ""}, {"B", ""}};
    catalog.position_min = Steps(-1000), catalog.position_max = Steps(1000);
    catalog.jog_speed_min = Pps(1), catalog.jog_speed_max = Pps(5000);
    now.axis_count = 2;
    now.axes[1].position = Steps(900);
  }
  std::string refusal(std::vector<AxisTarget> all, MoveBase base = MoveBase::zero, intent::Pace pace = {}) {
    const auto checked = check_move(catalog, now, all, base, pace);
    return checked ? "" : checked.error().sentence();
  }
  Catalog catalog;
  Snapshot now;
};

TEST_F(TargetCheck, TheTargetsAreThoseOfTheMove) {
  const std::vector<AxisTarget> all{{AxisId{1}, Steps(50)}, {AxisId{0}, Steps(-1000)}};
  EXPECT_THAT(*check_move(catalog, now, all, MoveBase::zero, {}), ElementsAre(Steps(50), Steps(-1000)));
  EXPECT_THAT(*check_move(catalog, now, all, MoveBase::position, {}), ElementsAre(Steps(950), Steps(-1000)));
}

TEST_F(TargetCheck, WhatTheControllerCannotReachIsRefused) {
  EXPECT_THAT(refusal({{AxisId{2}, Steps(0)}}), HasSubstr("There is no axis 3. Nothing was sent."));
  EXPECT_THAT(refusal({{AxisId{0}, Steps(0)}, {AxisId{1}, Steps(1001)}}),
              HasSubstr("out of the range of axis B, -1000 to 1000"));
  EXPECT_EQ(refusal({{AxisId{1}, Steps(100)}}, MoveBase::position), "");
  EXPECT_THAT(refusal({{AxisId{1}, Steps(101)}}, MoveBase::position),
              HasSubstr("101 steps from 900 is out of the range"));
  EXPECT_NE(refusal({{AxisId{1}, Steps(std::numeric_limits<std::int64_t>::max())}}, MoveBase::position), "");
}

TEST_F(TargetCheck, ASpeedOrRampThatTheControllerDoesNotHaveIsRefused) {
  intent::Pace pace;
  pace.speed = Pps(5000);
  EXPECT_EQ(refusal({{AxisId{0}, Steps(0)}}, MoveBase::zero, pace), "");
  pace.speed = Pps(5001);
  EXPECT_THAT(refusal({{AxisId{0}, Steps(0)}}, MoveBase::zero, pace),
              HasSubstr("5001 steps/s is not a possible speed. The range is 1 to 5000."));
  pace.speed = Pps(0.5);
  EXPECT_NE(refusal({{AxisId{0}, Steps(0)}}, MoveBase::zero, pace), "");
  pace.speed = Pps(0), pace.acceleration = 30;
  EXPECT_THAT(refusal({{AxisId{0}, Steps(0)}}, MoveBase::zero, pace), HasSubstr("one ramp for all motions"));
}

}  // namespace
}  // namespace hw
