#include "core/drawing/contour_path.h"

#include <numbers>

#include <gtest/gtest.h>

namespace hw::drawing {
namespace {

sequence::Step straight_to(double x, double y) {
  sequence::Move m;
  m.to[0] = x, m.to[1] = y;
  return {m};
}

TEST(ContourPath, LegsFollowEachOtherBehindTheLeadIn) {
  sequence::Contour c;
  c.lead_in = 7;
  c.steps = {straight_to(100, 0),
             {sequence::Output{3, true}},
             {sequence::Arc{100, 50, 180, {}}},
             {sequence::Output{3, false}},
             straight_to(0, 100)};
  const ToolPath path = contour_path(c, {1, 1});
  ASSERT_EQ(path.runs.size(), 4u);
  EXPECT_EQ(path.points.front(), (Point{-7, 0}));
  EXPECT_EQ(path.runs[0].source, -1);
  EXPECT_FALSE(path.runs[0].tool_on);
  EXPECT_FALSE(path.runs[1].tool_on);
  EXPECT_TRUE(path.runs[2].tool_on);
  EXPECT_EQ(path.runs[2].source, 2);
  EXPECT_FALSE(path.runs[3].tool_on);
  EXPECT_NEAR(path.way_on, 50 * std::numbers::pi, 0.01);
  EXPECT_NEAR(path.way_off, 7 + 200, 1e-6);
  EXPECT_NEAR(path.points.back().x, 0, 1e-9);
  EXPECT_NEAR(path.points.back().y, 100, 1e-9);
}

TEST(ContourPath, StepsWithoutLengthArePassedOver) {
  sequence::Contour c;
  c.steps = {
      straight_to(0, 0), {sequence::Arc{0, 0, 90, {}}}, {sequence::Arc{5, 0, 0, {}}}, straight_to(3, 4)};
  const ToolPath path = contour_path(c, {2, 0.5});
  ASSERT_EQ(path.runs.size(), 1u);
  EXPECT_EQ(path.runs[0].source, 3);
  EXPECT_TRUE(path.runs[0].tool_on) << "where no output is ever on, all of it is drawn";
  EXPECT_EQ(path.points.back(), (Point{6, 2}));
}

}  // namespace
}  // namespace hw::drawing
