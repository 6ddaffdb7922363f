#include "core/drawing/sequence_path.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hw::drawing {
namespace {

using namespace sequence;

Step to(double x, double y, bool relative = false) {
  Move m;
  m.to[0] = x, m.to[1] = y;
  m.relative = relative;
  return {m};
}

TEST(SequencePath, MovesArcsAndThePen) {
  Sequence s;
  s.steps = {{Pen{false}},          to(10, 0),    {Pen{true}}, to(0, 5, true),
             {Arc{10, 0, 180, {}}}, {Pen{false}}, to(0, 0)};
  const ToolPath path = sequence_path(s, {1, 1});
  EXPECT_NEAR(path.way_on, 5 + 5 * std::numbers::pi, 0.01);
  EXPECT_NEAR(path.way_off, 10 + std::hypot(10, 5), 1e-6);
  EXPECT_NEAR(path.bounds.low.y, -5, 1e-6);
  EXPECT_EQ(path.runs.front().source, 1);
  EXPECT_EQ(path.runs.back().source, 6);
}

TEST(SequencePath, ArcsAreChordsWhereTheMachineDrawsThem) {
  Sequence s;
  s.steps = {to(10, 0), {Arc{0, 0, 360, {}}}};
  const double beside = 10 * (1 - std::cos(std::numbers::pi / 8));  // of chords of 45 degrees
  const ToolPath path = sequence_path(s, {1, 1}, beside * 1.001);
  EXPECT_NEAR(path.way_on, 10 + 8 * 2 * 10 * std::sin(std::numbers::pi / 8), 1e-6) << "eight of them";
  EXPECT_NEAR(path.points.back().x, 10, 1e-9);
  EXPECT_NEAR(path.points.back().y, 0, 1e-9);
}

TEST(SequencePath, AnArcLiesInItsOwnTwoAxes) {
  Sequence s;
  s.axes = {{"X"}, {"Y"}, {"Z"}};
  s.steps = {to(10, 3), {Arc{0, 0, 90, {}, {0, 2}}}};
  const ToolPath side = sequence_path_in(s, {0, 2, -1, {1, 1, 1}, 0, {}});
  EXPECT_NEAR(side.points.back().x, 0, 1e-9);
  EXPECT_NEAR(side.points.back().y, 10, 1e-9);
  const ToolPath above = sequence_path(s, {1, 1});
  EXPECT_NEAR(above.points.back().x, 0, 1e-9);
  EXPECT_NEAR(above.points.back().y, 3, 1e-9) << "Y stays";
}

TEST(SequencePath, WithoutAPenAllOfItIsWork) {
  Sequence s;
  Repeat loop;
  loop.times = 3;
  loop.steps = {to(1, 0, true), to(0, 1, true)};
  s.steps = {to(5, 5), {loop}, to(0, 0)};
  s.steps.push_back(to(9, 9));
  s.steps.back().skipped = true;
  const ToolPath path = sequence_path(s, {2, 2});
  EXPECT_DOUBLE_EQ(path.way_off, 0);
  ASSERT_EQ(path.runs.size(), 3u);
  EXPECT_EQ(path.runs[0].source, 0);
  EXPECT_EQ(path.runs[1].source, 1);
  EXPECT_EQ(path.runs[2].source, 2);
  EXPECT_EQ(path.bounds.high, (Point{12, 12}));
}

TEST(SequencePath, ContoursGoTheirOwnWay) {
  Sequence s;
  s.steps = {{Contour{2, 3, 1, false, {}, {to(6, 3), {Output{1, true}}, to(6, 8)}}}};
  const ToolPath path = sequence_path(s, {1, 1});
  EXPECT_EQ(path.points.front(), (Point{1, 3}));
  EXPECT_EQ(path.points.back(), (Point{6, 8}));
  EXPECT_DOUBLE_EQ(path.way_on, 5);
}

}  // namespace
}  // namespace hw::drawing
