// A curve through points, where a file says no more of a spline.
#include "core/drawing/fit_spline.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/drawing/dxf_reader.h"

namespace hw::drawing {
namespace {

constexpr double near_by = 1e-9;

Spline spline_through(FitPoints fit) {
  auto shape = through(std::move(fit));
  EXPECT_TRUE(shape && std::holds_alternative<Spline>(*shape));
  if (!shape || !std::holds_alternative<Spline>(*shape)) return {};
  const Spline spline = std::get<Spline>(*shape);
  EXPECT_EQ(flaw_of(spline), "");
  return spline;
}

void expect_at(Point p, double x, double y, double within = near_by) {
  EXPECT_NEAR(p.x, x, within);
  EXPECT_NEAR(p.y, y, within);
}

Point direction_at(const Spline& s, double t, double step) {
  const Point from = point_at(s, t), to = point_at(s, t + step);
  const double way = std::hypot(to.x - from.x, to.y - from.y) * (step < 0 ? -1 : 1);
  return {(to.x - from.x) / way, (to.y - from.y) / way};
}

TEST(FitSpline, GoesThroughEachPointAtTheLengthOfTheChords) {
  const std::vector<Point> points{{0, 0}, {3, 4}, {3, 9}, {15, 9}};
  const Spline s = spline_through({points});
  double at = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    expect_at(point_at(s, at), points[i].x, points[i].y);
    if (i + 1 < points.size()) at += std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y);
  }
  EXPECT_DOUBLE_EQ(s.knots.back(), 5 + 5 + 12);
}

TEST(FitSpline, IsSmoothToItsCurvature) {
  const Spline s = spline_through({{{0, 0}, {3, 4}, {3, 9}, {15, 9}}});
  constexpr double step = 1e-3;
  for (const double knot : {5.0, 10.0}) {
    const auto bend = [&](double to) {
      const Point a = point_at(s, knot), b = point_at(s, knot + to), c = point_at(s, knot + 2 * to);
      return Point{(a.x - 2 * b.x + c.x) / (step * step), (a.y - 2 * b.y + c.y) / (step * step)};
    };
    const Point before = bend(-step), behind = bend(step);
    expect_at(before, behind.x, behind.y, 0.01);
  }
}

TEST(FitSpline, LeavesInTheGivenDirections) {
  const Spline s = spline_through({{{0, 0}, {1, 3}, {5, 2}}, false, {2, 0}, {0, -7}});
  expect_at(direction_at(s, 0, 1e-6), 1, 0, 1e-5);
  expect_at(direction_at(s, s.knots.back(), -1e-6), 0, -1, 1e-5);
}

TEST(FitSpline, OfAClosedOneTheEndGoesOnInItsBeginning) {
  const Spline s = spline_through({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true});
  const double all = s.knots.back();
  expect_at(point_at(s, all), 0, 0);
  const Point begin = direction_at(s, 0, 1e-6), end = direction_at(s, all, -1e-6);
  expect_at(begin, end.x, end.y, 1e-5);
}

TEST(FitSpline, PointsOnALineAreDrawnStraightAndTwoAreALine) {
  const Spline s = spline_through({{{0, 0}, {1, 1}, {5, 5}}});
  for (int i = 0; i <= 20; ++i) {
    const Point p = point_at(s, s.knots.back() * i / 20);
    EXPECT_NEAR(p.x, p.y, near_by);
  }
  const auto line = through({{{1, 2}, {1, 2}, {4, 6}}});
  ASSERT_TRUE(line && std::holds_alternative<Line>(*line)) << "a point twice is one";
  expect_at(std::get<Line>(*line).to, 4, 6);
  EXPECT_FALSE(through({{{1, 2}, {1, 2}}}));
  EXPECT_FALSE(through({}));
}

TEST(FitSpline, AFileOfFitPointsAloneIsDrawnAndReported) {
  const std::string head = "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n8\n0\n70\n8\n71\n3\n72\n0\n73\n0\n74\n3\n";
  const auto points = [](const char* last_height) {
    return std::string("11\n0\n21\n0\n31\n0\n11\n1\n21\n3\n31\n0\n11\n5\n21\n2\n31\n") + last_height + "\n";
  };
  const std::string end = "0\nENDSEC\n0\nEOF\n";
  const auto drawing = read_dxf(head + points("0") + end, "a.dxf", Tolerance{1e-6});
  ASSERT_TRUE(drawing);
  ASSERT_EQ(drawing->paths.size(), 1u);
  EXPECT_NEAR(length_of(*drawing), 7.585946584, 1e-5) << "as ezdxf draws it";
  ASSERT_EQ(drawing->understood.size(), 1u);
  EXPECT_EQ(drawing->understood[0].what, "SPLINE");
  EXPECT_THAT(drawing->understood[0].why, testing::HasSubstr("smooth curve through them"));
  const auto askew = read_dxf(head + points("1") + end, "a.dxf", Tolerance{1e-6});
  ASSERT_TRUE(askew);
  ASSERT_EQ(askew->left_out.size(), 1u);
  EXPECT_EQ(askew->left_out[0].why, "it is not flat");
}

TEST(FitSpline, PointsBeyondNumbersAreLeftOut) {
  std::string text = "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n8\n0\n70\n8\n71\n3\n72\n0\n73\n0\n74\n3\n";
  for (const char* x : {"0", "1e300", "-1e308"}) text += std::string("11\n") + x + "\n21\n" + x + "\n31\n0\n";
  const auto drawing = read_dxf(text + "0\nENDSEC\n0\nEOF\n", "a.dxf", Tolerance{1e-6});
  ASSERT_TRUE(drawing);
  EXPECT_TRUE(drawing->paths.empty());
  ASSERT_EQ(drawing->left_out.size(), 1u);
  EXPECT_THAT(drawing->left_out[0].why, testing::HasSubstr("too far apart"));
  EXPECT_TRUE(drawing->understood.empty());
}

}  // namespace
}  // namespace hw::drawing
