// A piece that a program draws is bound by the user's travel on its whole way, bulges of arcs among it.
#include <gmock/gmock.h>

#include "core/device/pieces.h"
#include "core/device/registry.h"
#include "core/device/travel_check.h"

namespace hw {
namespace {

namespace seq = sequence;

struct PiecesReach : testing::Test {
  PiecesReach() {
    s.axes = {{"X"}, {"Y"}};
    now.axis_count = 2;
    for (AxisState& axis : now.axes) axis.position_known = true;
  }
  static seq::Move to(double x, double y) {
    seq::Move m;
    m.to[0] = x, m.to[1] = y;
    return m;
  }
  std::optional<PastTravel> past(seq::StepList steps) {
    s.steps = std::move(steps);
    auto pieces = cut_by_text(type.language(), s, catalog, 0);
    EXPECT_TRUE(pieces) << pieces.error().sentence();
    if (!pieces) return {};
    return past_travel(catalog, now, intent::RunInPieces(std::make_shared<const Pieces>(std::move(*pieces))));
  }
  void bound(int axis, Steps minus, Steps plus) {
    now.axes[static_cast<std::size_t>(axis)].travel = {true, true, minus, plus};
  }
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  const Catalog catalog = *type.make_catalog({});
  Snapshot now;
  seq::Sequence s;
};

TEST_F(PiecesReach, ABulgeBeyondALimitIsRefusedThoughItsEndsAreNot) {
  bound(1, Steps(-500), Steps(500));
  EXPECT_FALSE(past({{to(400, 0)}, {seq::Arc{0, 0, 180}}}));
  const auto found = past({{to(1000, 0)}, {seq::Arc{0, 0, 180}}});
  ASSERT_TRUE(found) << "up to 1000 between two ends at 0";
  EXPECT_EQ(found->axis, AxisId{1});
  EXPECT_EQ(found->side, Sign::plus);
  EXPECT_EQ(found->place, Steps(1000));
  EXPECT_FALSE(past({{to(1000, 0)}, {seq::Arc{1000, 200, 180}}})) << "it stays below 400";
}

TEST_F(PiecesReach, SoIsACornerInTheMiddleOfAProgram) {
  bound(0, Steps(-500), Steps(500));
  const auto found = past({{to(0, 0)}, {to(-700, 0)}, {to(0, 0)}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->side, Sign::minus);
  EXPECT_EQ(found->place, Steps(-700));
}

TEST_F(PiecesReach, AndALoopThatMovesOnInEachOfItsRounds) {
  bound(0, Steps(-500), Steps(500));
  seq::Move by;
  by.to[0] = 100, by.relative = true;
  EXPECT_FALSE(past({{to(0, 0)}, {seq::Repeat{5, {{by}}}}}));
  const auto found = past({{to(0, 0)}, {seq::Repeat{6, {{by}}}}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->place, Steps(600));
  EXPECT_TRUE(past({{to(0, 0)}, {seq::Repeat{0, {{by}}}}})) << "it has no end";
}

}  // namespace
}  // namespace hw
