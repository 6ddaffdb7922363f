// A move is checked before its driver sees it: axes, targets, speed and ramp.
#include "core/device/target_check.h"

#include <limits>
#include <optional>

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
  std::string refusal(std::vector<AxisTarget> all, MoveBase base = MoveBase::zero) {
    const auto checked = check_move(catalog, now, all, base);
    return checked ? "" : checked.error().sentence();
  }
  std::string refusal(double speed, std::optional<std::int64_t> acceleration = {},
                      AccelerationUnit unit = {"ms", "", 10, 500}) {
    const auto checked = check_pace(catalog, unit, {Pps(speed), acceleration});
    return checked ? "" : checked.error().sentence();
  }
  Catalog catalog;
  Snapshot now;
};

TEST_F(TargetCheck, TheTargetsAreThoseOfTheMove) {
  const std::vector<AxisTarget> all{{AxisId{1}, Steps(50)}, {AxisId{0}, Steps(-1000)}};
  EXPECT_THAT(*check_move(catalog, now, all, MoveBase::zero), ElementsAre(Steps(50), Steps(-1000)));
  EXPECT_THAT(*check_move(catalog, now, all, MoveBase::position), ElementsAre(Steps(950), Steps(-1000)));
}

TEST_F(TargetCheck, UnreachableTargetsAreRefused) {
  EXPECT_THAT(refusal({{AxisId{2}, Steps(0)}}), HasSubstr("There is no axis 3. Nothing was sent."));
  EXPECT_THAT(refusal({{AxisId{0}, Steps(0)}, {AxisId{1}, Steps(1001)}}),
              HasSubstr("Position 1001 of axis B lies outside its range, -1000 to 1000. Nothing was sent."));
  EXPECT_EQ(refusal({{AxisId{1}, Steps(100)}}, MoveBase::position), "");
  EXPECT_THAT(refusal({{AxisId{1}, Steps(101)}}, MoveBase::position),
              HasSubstr("Position 1001 of axis B lies outside its range"));
  EXPECT_NE(refusal({{AxisId{1}, Steps(std::numeric_limits<std::int64_t>::max())}}, MoveBase::position), "");
}

TEST_F(TargetCheck, APaceIsRounded) {
  const auto pace = check_pace(catalog, {"ms", "", 10, 500}, {Pps(4999.6), 30});
  ASSERT_TRUE(pace);
  EXPECT_EQ(pace->speed, 5000);
  EXPECT_EQ(pace->acceleration, 30);
  EXPECT_EQ(check_pace(catalog, {}, {})->speed, 0) << "its own";
}

TEST_F(TargetCheck, ASpeedThatTheControllerDoesNotHaveIsRefused) {
  EXPECT_EQ(refusal(5000), "");
  EXPECT_EQ(refusal(5001),
            "A speed of 5001 is not possible. The range is 1 to 5000 steps/s. Nothing was sent.");
  EXPECT_EQ(refusal(1), "");
  EXPECT_NE(refusal(0.4), "") << "0 would be its own speed, which may be much faster";
  EXPECT_NE(refusal(-20), "");
  EXPECT_NE(refusal(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_NE(refusal(std::numeric_limits<double>::infinity()), "");
}

TEST_F(TargetCheck, ARampThatTheControllerDoesNotHaveIsRefused) {
  EXPECT_EQ(refusal(0, 10), "");
  EXPECT_EQ(refusal(0, 500), "");
  EXPECT_EQ(refusal(0, 501),
            "An acceleration of 501 is not possible. The range is 10 to 500 ms. Nothing was sent.");
  EXPECT_NE(refusal(0, 0), "") << "asked for, it is no way to say: its own";
  EXPECT_THAT(refusal(0, 30, {}), HasSubstr("one ramp for all motions"));
}

}  // namespace
}  // namespace hw
