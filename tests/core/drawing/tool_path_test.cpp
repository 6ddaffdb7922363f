// The way of a tool, and the view of it.
#include "core/drawing/tool_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>

#include "core/drawing/path_svg.h"

namespace hw::drawing {
namespace {

TEST(ToolPath, CollinearSegmentsBecomeOneLine) {
  ToolPath path;
  for (int i = 0; i < 100; ++i) path.go({i * 1.0, i * 2.0}, {i + 1.0, i * 2.0 + 2}, true, 3);
  path.go({100, 200}, {100, 150}, true, 3);
  ASSERT_EQ(path.runs.size(), 1u);
  EXPECT_EQ(path.points, (std::vector<Point3>{{0, 0}, {100, 200}, {100, 150}}));
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

TEST(ToolPath, TheNearestPartIsFoundInPerspective) {
  ToolPath path;
  path.go({0, 0, 0}, {100, 0, 0}, true, 7);
  path.go({100, 0, 0}, {100, 0, 50}, true, 8);  // upwards: seen from the top it is all but a point
  for (const ViewDirection& from : {views::iso, views::front, ViewDirection{-30, 10}}) {
    const PathView view(path.bounds, Projection(path.bounds, from, true), 400, 400, true);
    const Point px = view.to_px({100, 0, 20});
    const auto hit = nearest(path, view, {px.x - 3, px.y}, 8);
    ASSERT_TRUE(hit);
    EXPECT_EQ(path.runs[hit->run].source, 8);
    EXPECT_NEAR(hit->at.x, 100, 1e-9);
    EXPECT_NEAR(view.to_px(hit->at).y, px.y, 3)
        << "it lies where the pointer is, though its far half is short";
  }
}

TEST(ToolPath, AFewLinesShowTheSameWay) {
  ToolPath path;
  for (int i = 0; i < 50'000; ++i) {
    const double a = i * 1e-3, b = (i + 1) * 1e-3;
    path.go({100 * std::cos(a), 100 * std::sin(a), i * 1e-3},
            {100 * std::cos(b), 100 * std::sin(b), (i + 1) * 1e-3}, i % 1000 < 900, i);
  }
  const ToolPath few = coarser(path, 2000);
  EXPECT_LE(few.points.size(), 2000u);
  EXPECT_GT(few.points.size(), 200u);
  EXPECT_NEAR(few.bounds.high.z, path.bounds.high.z, 1);
  EXPECT_NEAR(few.bounds.low.x, path.bounds.low.x, 1);
  EXPECT_NEAR(few.way_off / (few.way_on + few.way_off), 0.1, 0.03);
  ToolPath square;
  square.go({0, 0}, {1, 0}, true, 0), square.go({1, 0}, {1, 1}, false, 1);
  EXPECT_EQ(coarser(square, 2000).points, square.points);
  EXPECT_TRUE(coarser(ToolPath(), 2000).points.empty());
}

TEST(ToolPath, FlattenedItIsAsItLooks) {
  ToolPath path;
  path.go({0, 0, 0}, {10, 20, 30}, true, 4);
  const Projection front(path.bounds, views::front, true);
  const ToolPath flat = flattened(path, front);
  EXPECT_EQ(flat.runs.front().source, 4);
  EXPECT_EQ(flat.points.back(), Point3(front.on_plane({10, 20, 30})));
  EXPECT_EQ(flat.bounds.size().z, 0);
  EXPECT_EQ(flattened(path, Projection()).points.back(), (Point3{10, 20}));
}

TEST(PathSvg, IsAsLargeAsThePathAndTheRightWayUp) {
  ToolPath path;
  path.go({0, 0}, {100, 0}, true, 0);
  path.go({100, 0}, {100, 50}, false, 0);
  ToolPath meant;
  meant.go({0, 0}, {100, 50}, true, 0);
  const std::array layers{SvgLayer{"commanded", &meant, "#9b2463", 1}, SvgLayer{"home", nullptr},
                          SvgLayer{"rehearsed", &path}};
  const std::string svg = path_svg(layers, {"mm", "X in mm, Y < 3"});
  EXPECT_THAT(
      svg, testing::ContainsRegex("width=\"104mm\" height=\"60[.0-9]+mm\" viewBox=\"-2 -52 104 60[.0-9]+\""));
  EXPECT_THAT(svg, testing::HasSubstr("<desc>X in mm, Y &lt; 3</desc>"));
  EXPECT_THAT(svg, testing::ContainsRegex("<g id=\"commanded\" stroke=\"#9b2463\"[^>]*>\n<polyline points="
                                          "\"0,-0 100,-50\"/>\n</g>"));
  EXPECT_THAT(svg, testing::ContainsRegex("<g id=\"rehearsed\"[^>]*>\n<polyline points=\"0,-0 100,-0\"/>"));
  EXPECT_THAT(svg, testing::ContainsRegex(
                       "<g id=\"rehearsed-tool-off\"[^>]*>\n<polyline points=\"100,-0 100,-50\"/>"));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("home"))) << "what is not there has no group";
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("direction"))) << "none of them is directed";
  EXPECT_THAT(path_svg(layers, {"steps", ""}), testing::HasSubstr("width=\"800\" viewBox"));
  EXPECT_THAT(path_svg(layers, {}), testing::Not(testing::HasSubstr("scale")));
}

TEST(PathSvg, ABarShowsItsScale) {
  ToolPath path;
  path.go({0, 0}, {130, 0}, true, 0);
  path.go({130, 0}, {130, 60}, true, 0);
  const std::array layers{SvgLayer{"rehearsed", &path}};
  const std::string svg = path_svg(layers, {"steps", "X in steps to the right"});
  EXPECT_THAT(svg,
              testing::ContainsRegex("<g id=\"scale\"[^>]*>\n<polyline points=\"0,[.0-9]+ 20,[.0-9]+\"/>"));
  EXPECT_THAT(svg, testing::HasSubstr(">20 steps</text>"));
  EXPECT_THAT(svg, testing::HasSubstr(">X in steps to the right</text>"));
}

TEST(PathSvg, ArrowsShowTheDirection) {
  ToolPath path;
  for (int i = 0; i < 1000; ++i) path.go({i * 1.0, 0}, {i + 1.0, 1.0 * (i % 2)}, true, i);
  path.go({1000, 1}, {0, 500}, false, 0);
  const std::array layers{SvgLayer{"rehearsed", &path, "#000", 2, true}};
  const std::string svg = path_svg(layers, {"mm", ""});
  const std::size_t group = svg.find("<g id=\"rehearsed-direction\"");
  ASSERT_NE(group, svg.npos);
  const std::string arrows = svg.substr(group, svg.find("</g>", group) - group);
  const auto count = static_cast<std::size_t>(std::count(arrows.begin(), arrows.end(), '\n')) - 1;
  EXPECT_GT(count, 8u);
  EXPECT_LT(count, 40u) << "not one on each line";
  // The last one points back: its tip lies left of both its ends.
  double left_x = 0, tip_x = 0, right_x = 0, y = 0;
  const std::string last = arrows.substr(arrows.rfind("<polyline"));
  ASSERT_EQ(
      std::sscanf(last.c_str(), "<polyline points=\"%lf,%lf %lf,%lf %lf", &left_x, &y, &tip_x, &y, &right_x),
      5);
  EXPECT_LT(tip_x, left_x);
  EXPECT_LT(tip_x, right_x);
}

}  // namespace
}  // namespace hw::drawing
