// The way of a tool, and the view of it.
#include "core/drawing/tool_path.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/drawing/path_svg.h"

namespace hw::drawing {
namespace {

TEST(ToolPath, WhatGoesStraightOnIsOneLine) {
  ToolPath path;
  for (int i = 0; i < 100; ++i) path.go({i * 1.0, i * 2.0}, {i + 1.0, i * 2.0 + 2}, true, 3);
  path.go({100, 200}, {100, 150}, true, 3);
  ASSERT_EQ(path.runs.size(), 1u);
  EXPECT_EQ(path.points, (std::vector<Point>{{0, 0}, {100, 200}, {100, 150}}));
  EXPECT_NEAR(path.way_on, 100 * std::sqrt(5) + 50, 1e-9);
}

TEST(ToolPath, BackAndForthKeepsItsTurn) {
  ToolPath path;
  path.go({0, 0}, {10, 0}, true, 0);
  path.go({10, 0}, {5, 0}, true, 0);
  EXPECT_EQ(path.points.size(), 3u);
  EXPECT_EQ(path.bounds.high, (Point{10, 0}));
}

TEST(ToolPath, ToolAndLineBeginRunsOfTheirOwn) {
  ToolPath path;
  path.go({0, 0}, {1, 0}, false, 1);
  path.go({1, 0}, {2, 0}, true, 1);
  path.go({2, 0}, {3, 0}, true, 2);
  path.go({9, 9}, {9, 8}, true, 2);  // carried there by nobody
  ASSERT_EQ(path.runs.size(), 4u);
  EXPECT_FALSE(path.runs[0].tool_on);
  EXPECT_EQ(path.runs[2].source, 2);
  EXPECT_EQ(path.points[path.runs[3].first], (Point{9, 9}));
  EXPECT_DOUBLE_EQ(path.way_off, 1);
  EXPECT_DOUBLE_EQ(path.way_on, 3);
}

Box box_of(Point a, Point b) {
  Box box;
  box.add(a), box.add(b);
  return box;
}

TEST(PathView, ShowsAllOfABoxWithEqualScales) {
  const PathView view(box_of({-10, 0}, {30, 20}), 400, 400, true);
  EXPECT_DOUBLE_EQ(view.per_px().x, view.per_px().y);
  const Point low = view.to_px({-10, 0}), high = view.to_px({30, 20});
  EXPECT_GT(low.x, 0);
  EXPECT_LT(high.x, 400);
  EXPECT_GT(high.y, 0);
  EXPECT_LT(low.y, 400) << "y goes upwards";
  EXPECT_NEAR((low.x + high.x) / 2, 200, 1e-9);
}

TEST(PathView, WhatLiesUnderThePointerStaysThereWhenItComesNearer) {
  PathView view(box_of({0, 0}, {100, 100}), 500, 300, true);
  const Point kept = view.from_px({37, 211});
  for (int i = 0; i < 30; ++i) view.zoom({37, 211}, 1.25);
  EXPECT_NEAR(view.from_px({37, 211}).x, kept.x, 1e-9);
  EXPECT_NEAR(view.from_px({37, 211}).y, kept.y, 1e-9);
  const Point before = view.to_px(kept);
  view.pan(5, -3);
  EXPECT_NEAR(view.to_px(kept).x, before.x + 5, 1e-6);
  EXPECT_NEAR(view.to_px(kept).y, before.y - 3, 1e-6);
}

TEST(PathView, ZoomingEndsWhereNumbersDo) {
  PathView view(box_of({0, 0}, {100, 100}), 500, 300, true);
  for (int i = 0; i < 1000; ++i) view.zoom({250, 150}, 2);
  EXPECT_GT(view.per_px().x, 0);
  for (int i = 0; i < 1000; ++i) view.zoom({250, 150}, 0.5);
  EXPECT_LT(view.per_px().x, 1e13);
  view.zoom({250, 150}, 0);
  view.zoom({250, 150}, -1);
  EXPECT_GT(view.per_px().x, 0);
}

TEST(PathView, TheSamePartIsShownInAnotherSize) {
  PathView view(box_of({0, 0}, {100, 50}), 500, 300, true);
  view.resize(1000, 600);
  const PathView fresh(box_of({0, 0}, {100, 50}), 1000, 600, true);
  EXPECT_NEAR(view.to_px({100, 50}).x, fresh.to_px({100, 50}).x, 1e-9);
  EXPECT_NEAR(view.to_px({0, 0}).y, fresh.to_px({0, 0}).y, 1e-9);
}

TEST(PathView, APointHasAViewToo) {
  const PathView view(box_of({5, 5}, {5, 5}), 500, 300, false);
  EXPECT_NEAR(view.to_px({5, 5}).x, 250, 1e-6);
  EXPECT_GT(view.per_px().y, 0);
}

TEST(ToolPath, TheNearestPartIsFound) {
  ToolPath path;
  path.go({0, 0}, {100, 0}, true, 7);
  path.go({100, 0}, {100, 50}, true, 8);
  const PathView view(path.bounds, 400, 400, true);
  const Point on_second = view.to_px({100, 25});
  const auto hit = nearest(path, view, {on_second.x - 5, on_second.y}, 8);
  ASSERT_TRUE(hit);
  EXPECT_EQ(path.runs[hit->run].source, 8);
  EXPECT_NEAR(hit->at.x, 100, 1e-9);
  EXPECT_NEAR(hit->at.y, 25, 1e-9);
  EXPECT_FALSE(nearest(path, view, {on_second.x - 9, on_second.y}, 8));
}

TEST(PathSvg, IsAsLargeAsThePathAndTheRightWayUp) {
  ToolPath path;
  path.go({0, 0}, {100, 0}, true, 0);
  path.go({100, 0}, {100, 50}, false, 0);
  const std::string svg = path_svg(path, "mm");
  EXPECT_THAT(svg, testing::HasSubstr("width=\"104mm\" height=\"54mm\" viewBox=\"-2 -52 104 54\""));
  EXPECT_THAT(svg, testing::HasSubstr("<polyline class=\"on\" points=\"0,-0 100,-0\"/>"));
  EXPECT_THAT(svg, testing::HasSubstr("<polyline class=\"off\" points=\"100,-0 100,-50\"/>"));
  EXPECT_THAT(path_svg(path, "steps"), testing::HasSubstr("width=\"800\" viewBox"));
}

}  // namespace
}  // namespace hw::drawing
