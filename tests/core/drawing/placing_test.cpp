// From chains to steps: where they come to lie, and what is made of lines and arcs.
#include "core/drawing/placing.h"

#include <cmath>

#include <gmock/gmock.h>

namespace hw::drawing {
namespace {

using namespace sequence;

Curve straight(Point from, Point to) { return {Curve::Kind::line, from, to, {}, 0}; }
Curve quarter(Point from, Point to, Point centre, double degrees) {
  return {Curve::Kind::arc, from, to, centre, degrees};
}
Chain chain(std::vector<Curve> curves) {
  Chain c;
  c.curves = std::move(curves);
  return c;
}
/// An L with a rounded corner.
std::vector<Chain> corner() {
  return {chain({straight({10, 20}, {14, 20}), quarter({14, 20}, {16, 22}, {14, 22}, 90),
                 straight({16, 22}, {16, 30})})};
}
std::string words(const Sequence& s) {
  std::string all;
  for (const Step& step : s.steps) {
    all += all.empty() ? "" : " ";
    if (const auto* m = std::get_if<Move>(&step.body)) {
      all += "to";
      for (const int a : {0, 1})
        if (m->to[static_cast<std::size_t>(a)])
          all += (a ? " y" : " x") + std::to_string(std::lround(*m->to[static_cast<std::size_t>(a)]));
    } else if (const auto* arc = std::get_if<Arc>(&step.body)) {
      all += "arc" + std::to_string(std::lround(arc->degrees));
    } else if (const auto* pen = std::get_if<Pen>(&step.body)) {
      all += pen->down ? "down" : "up";
    } else if (const auto* c = std::get_if<Contour>(&step.body)) {
      all += "contour" + std::to_string(c->steps.size());
    } else if (std::holds_alternative<WaitMotion>(step.body)) {
      all += "wait";
    } else {
      all += "speed";
    }
  }
  return all;
}
std::string drawn(const std::vector<Chain>& chains, const Tool& tool, Sequence s = {}) {
  draw_chains(chains, tool, s);
  return words(s);
}

TEST(Placing, AsDrawnScaledMirroredAndSwapped) {
  auto c = corner();
  Placing p;
  p.scale = 2;
  place(c, p);
  EXPECT_EQ(c[0].begin(), (Point{20, 40}));
  EXPECT_EQ(c[0].curves[1].degrees, 90);

  c = corner(), p = {};
  p.origin = Placing::Origin::lower_left, p.mirrored_x = true;
  place(c, p);
  EXPECT_EQ(c[0].begin(), (Point{6, 0}));
  EXPECT_EQ(c[0].end(), (Point{0, 10}));
  EXPECT_EQ(c[0].curves[1].degrees, -90) << "a mirror turns the other way round";
  EXPECT_EQ(c[0].curves[1].centre, (Point{2, 2}));

  c = corner(), p = {};
  p.origin = Placing::Origin::point, p.point = {14, 20}, p.swapped = true;
  place(c, p);
  EXPECT_EQ(c[0].begin(), (Point{0, -4}));
  EXPECT_EQ(c[0].end(), (Point{10, 2}));
  EXPECT_EQ(c[0].curves[1].degrees, -90);
}

TEST(Placing, ThePlaceOfTheDrawingIsFoundAgain) {
  for (const bool swapped : {false, true}) {
    auto c = corner();
    const Point was = c[0].curves[1].from;
    Placing p;
    p.scale = 25.4, p.swapped = swapped, p.mirrored_y = true;
    p.origin = Placing::Origin::lower_left;
    const Affine placed = place(c, p);
    const Point back = placed.undone(c[0].curves[1].from);
    EXPECT_NEAR(back.x, was.x, 1e-12);
    EXPECT_NEAR(back.y, was.y, 1e-12);
  }
}

TEST(Placing, AFrameGoesOnceAroundWithTheToolUp) {
  Box box;
  box.add({1, 2}), box.add({5, 8});
  Sequence s;
  draw_frame(box, {}, s);
  EXPECT_EQ(words(s), "up to x1 y2 wait to x5 y2 wait to x5 y8 wait to x1 y8 wait to x1 y2 wait");
}

TEST(Placing, AnArcStaysOneWhereTheMachineHasIt) {
  Tool tool;
  tool.curve_mode = CurveMode::arcs;
  EXPECT_EQ(drawn(corner(), tool), "up to x10 y20 wait down to x14 y20 arc90 to x16 y30 wait up");
}

TEST(Placing, ChordsLieWithinTheTolerance) {
  for (const double tolerance : {0.5, 0.01, 0.0001}) {
    std::vector<Point> points{{14, 20}};
    chords(corner()[0].curves[1], tolerance, [&](Point p) { points.push_back(p); });
    EXPECT_EQ(points.back(), (Point{16, 22}));
    for (std::size_t n = 1; n < points.size(); ++n) {
      const Point middle{(points[n].x + points[n - 1].x) / 2, (points[n].y + points[n - 1].y) / 2};
      EXPECT_NEAR(std::hypot(points[n].x - 14, points[n].y - 22), 2, 1e-9);
      EXPECT_GE(std::hypot(middle.x - 14, middle.y - 22), 2 - tolerance - 1e-9);
    }
    EXPECT_LT(static_cast<double>(points.size()), 3 + 2.5 / std::sqrt(tolerance))
        << "and no more than it takes";
  }
}

TEST(Placing, StairsLieWithinTheToleranceAndMoveOneAxisAtATime) {
  Tool tool;
  tool.curve_mode = CurveMode::stairs, tool.tolerance = 0.1;
  Sequence s;
  draw_chains({chain({straight({0, 0}, {30, -40})})}, tool, s);
  double x = 0, y = 0, farthest = 0;
  int moves = 0;
  for (const Step& step : s.steps)
    if (const auto* m = std::get_if<Move>(&step.body)) {
      EXPECT_NE(m->to[0].has_value(), m->to[1].has_value());
      x = m->to[0].value_or(x), y = m->to[1].value_or(y);
      farthest = std::max(farthest, std::fabs(x * 0.8 + y * 0.6));
      ++moves;
    }
  EXPECT_EQ(x, 30);
  EXPECT_EQ(y, -40);
  EXPECT_LE(farthest, 0.1);
  EXPECT_GT(farthest, 0.04);
  EXPECT_EQ(moves, 2 + 2 * 240 + 1) << "24 by the tolerance of 0.1, half of which is kept for chords";
  EXPECT_EQ(drawn({chain({straight({1, 1}, {9, 1}), straight({9, 1}, {9, 4})})}, tool),
            "up to x1 to y1 wait down to x9 to y4 wait up");
}

TEST(Placing, ADotLowersTheTool) {
  EXPECT_EQ(drawn({chain({straight({5, 5}, {5, 5})})}, Tool()), "up to x5 y5 wait down up");
}

TEST(Placing, SpeedsOfTravelAndOfCutting) {
  Tool tool;
  tool.travel = {100, 0, 0}, tool.cutting = {10, 0, 0};
  Sequence s;
  draw_chains({chain({straight({0, 0}, {30, -40})})}, tool, s);
  EXPECT_EQ(words(s), "speed up to x0 y0 wait down to x30 y-40 wait up");
  EXPECT_EQ(std::get<Move>(s.steps[2].body).own, Speeds{100});
  EXPECT_EQ(std::get<Move>(s.steps[5].body).own, Speeds{10});
}

TEST(Placing, AContourLeadsInWhereItsToolIsSwitchedOnTheWay) {
  Tool tool;
  tool.curve_mode = CurveMode::contours, tool.cutting = {10, 0, 500}, tool.contour_outputs = {14, 15};
  EXPECT_EQ(drawn(corner(), tool), "up to x10 y20 wait down contour3 wait up")
      << "no routines: from rest to rest";
  Sequence s;
  s.pen_down = {{Output{14, true}}}, s.pen_up = {{Output{14, false}}};
  draw_chains(corner(), tool, s);
  EXPECT_EQ(words(s), "up contour5");
  const auto& c = std::get<Contour>(s.steps[1].body);
  EXPECT_EQ(c.lead_in, 2.5) << "10 a second in half a second";
  EXPECT_TRUE(c.ends_ramped);
  s = {};
  s.pen_down = {{Output{8, true}}}, s.pen_up = {{Output{8, false}}};
  draw_chains(corner(), tool, s);
  EXPECT_EQ(words(s), "up to x10 y20 wait down contour3 wait up");
  EXPECT_FALSE(std::get<Contour>(s.steps[4].body).ends_ramped);
}

TEST(Placing, PiecesThatEndOnTheStepWhereTheyBeginAreNotDrawn) {
  Sequence s;
  s.axes = {{"X", 10}, {"Y", 10}};
  Tool tool;
  tool.curve_mode = CurveMode::contours;
  const auto c = chain({straight({0, 0}, {0.02, 0.01}), straight({0.02, 0.01}, {3, 0}),
                        quarter({3, 0}, {3, 0.02}, {3, 0.01}, 180), straight({3, 0.02}, {3, 4})});
  draw_chains({c}, tool, s);
  EXPECT_EQ(words(s), "up to x0 y0 wait down contour2 wait up");
  s.steps.clear();
  draw_chains({chain({quarter({1, 1}, {1, 1}, {1.01, 1}, 360)})}, tool, s);
  EXPECT_EQ(words(s), "up to x1 y1 wait down up") << "as small as a dot";
}

// Its centre may be further away than a controller can count.
TEST(Placing, AnArcThatIsStraightWithinTheToleranceIsALine) {
  Tool tool;
  tool.curve_mode = CurveMode::arcs;
  const double flat = 0.001;  // degrees
  const Point centre{5, 5 / std::tan(flat / 2 / 180 * std::acos(-1))};
  EXPECT_EQ(drawn({chain({quarter({0, 0}, {10, 0}, centre, flat)})}, tool),
            "up to x0 y0 wait down to x10 y0 wait up");
}

TEST(Placing, ALongChainIsSeveralContours) {
  std::vector<Curve> curves;
  for (int n = 0; n < 100; ++n) curves.push_back(straight({double(n), 0}, {double(n + 1), double(n % 2)}));
  for (std::size_t n = 1; n < curves.size(); ++n) curves[n].from = curves[n - 1].to;
  Tool tool;
  tool.curve_mode = CurveMode::contours;
  Sequence s;
  draw_chains({chain(curves)}, tool, s);
  EXPECT_EQ(words(s), "up to x0 y0 wait down contour40 contour40 contour20 wait up");
  const auto& second = std::get<Contour>(s.steps[5].body);
  EXPECT_EQ(second.x, 40);
  EXPECT_EQ(second.y, 1);
}

}  // namespace
}  // namespace hw::drawing
