#include "core/drawing/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw::drawing {
namespace {

constexpr double pi = std::numbers::pi;

double size(Point p) { return std::hypot(p.x, p.y); }
double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }
Point at(const Ellipse& e, double t) {
  return {e.centre.x + e.u.x * std::cos(t) + e.v.x * std::sin(t),
          e.centre.y + e.u.y * std::cos(t) + e.v.y * std::sin(t)};
}

bool is_circle(const Ellipse& e) {
  constexpr double rounding = 1e-9;
  const double u = size(e.u), v = size(e.v);
  return std::fabs(u - v) <= rounding * u && std::fabs(e.u.x * e.v.x + e.u.y * e.v.y) <= rounding * u * v;
}

void line_to(Point to, std::vector<Curve>& curves, Point from) {
  curves.push_back({Curve::Kind::line, from, to, {}, 0});
}

void draw_ellipse(const Ellipse& e, const Tolerance& tolerance, std::vector<Curve>& curves) {
  const double sweep = e.end - e.begin;
  if (is_circle(e)) {
    const double sense = cross(e.u, e.v) < 0 ? -1 : 1;
    const bool whole = std::fabs(sweep) >= 2 * pi * (1 - 1e-12);
    const Point from = at(e, e.begin);
    curves.push_back({Curve::Kind::arc, from, whole ? from : at(e, e.end), e.centre,
                      sense * (whole ? 360 : sweep / pi * 180)});
    return;
  }
  // An ellipse is a stretched unit circle, and a chord's gap is stretched likewise, by the half axis at most.
  const double half_axis = std::max(size(e.u), size(e.v)) * std::numbers::sqrt2;
  const double gap = std::clamp(tolerance.chord / half_axis, 1e-9, 1.0);
  const double step = 2 * std::acos(1 - gap);
  const int chords = std::clamp(static_cast<int>(std::ceil(std::fabs(sweep) / step)), 4, 100'000);
  Point before = at(e, e.begin);
  for (int n = 1; n <= chords; ++n) {
    const Point next = at(e, e.begin + sweep * n / chords);
    line_to(next, curves, std::exchange(before, next));
  }
}

double off_line(Point p, Point a, Point b) {
  const Point way{b.x - a.x, b.y - a.y}, here{p.x - a.x, p.y - a.y};
  const double square = way.x * way.x + way.y * way.y;
  if (square == 0) return size(here);
  const double along = std::clamp((here.x * way.x + here.y * way.y) / square, 0.0, 1.0);
  return std::hypot(here.x - along * way.x, here.y - along * way.y);
}

/// Draws a span of a spline between two knots, halved until its chords are close enough.
class SplineDrawing {
 public:
  SplineDrawing(const Spline& spline, double chord, std::vector<Curve>& curves)
      : spline_(spline), chord_(chord), curves_(curves) {}

  void span(double begin, double end) {
    const int parts = std::max(spline_.degree, 2);  // so that no bend hides between the sampled points
    for (int n = 0; n < parts; ++n) {
      const double from = begin + (end - begin) * n / parts, to = begin + (end - begin) * (n + 1) / parts;
      halve(from, point_at(spline_, from), to, point_at(spline_, to), 0);
    }
  }

 private:
  void halve(double t0, Point from, double t1, Point to, int depth) {
    constexpr int deepest = 14;
    constexpr double between_looks = 1.1;  // largest factor by which a cubic is further away between samples
    const double middle = (t0 + t1) / 2;
    const Point halfway = point_at(spline_, middle);
    const auto beside = [&](double t) { return off_line(point_at(spline_, t), from, to); };
    const double gap =
        std::max({off_line(halfway, from, to), beside((t0 + middle) / 2), beside((middle + t1) / 2)});
    if (depth >= deepest || gap * between_looks <= chord_) return line_to(to, curves_, from);
    halve(t0, from, middle, halfway, depth + 1);
    halve(middle, halfway, t1, to, depth + 1);
  }

  const Spline& spline_;
  double chord_;
  std::vector<Curve>& curves_;
};

void draw_spline(const Spline& s, const Tolerance& tolerance, std::vector<Curve>& curves) {
  SplineDrawing drawing(s, tolerance.chord, curves);
  const auto degree = static_cast<std::size_t>(s.degree);
  for (std::size_t i = degree; i < s.points.size(); ++i)
    if (s.knots[i] < s.knots[i + 1]) drawing.span(s.knots[i], s.knots[i + 1]);
}

}  // namespace

Affine Affine::after(const Affine& inner) const {
  const Point x = turned({inner.a, inner.b}), y = turned({inner.c, inner.d}),
              shift = (*this)({inner.e, inner.f});
  return {x.x, x.y, y.x, y.y, shift.x, shift.y};
}

Ellipse arc_of(Point centre, double radius, double begin_degrees, double end_degrees) {
  double sweep = std::fmod(end_degrees - begin_degrees, 360);
  if (sweep <= 0) sweep += 360;
  const double begin = begin_degrees / 180 * pi;
  return {centre, {radius, 0}, {0, radius}, begin, begin + sweep / 180 * pi};
}

Shape bulged(Point from, Point to, double bulge) {
  const Point way{to.x - from.x, to.y - from.y};
  constexpr double rounding = 1e-8;  // below: a centre too far away for exact ends
  if (std::fabs(bulge) < rounding || size(way) == 0) return Line{from, to};
  const double angle = 4 * std::atan(bulge);
  const double ahead = (1 / bulge - bulge) / 4;  // distance of the centre to the left of the chord's middle
  const Point centre{(from.x + to.x) / 2 - way.y * ahead, (from.y + to.y) / 2 + way.x * ahead};
  const Point u{from.x - centre.x, from.y - centre.y};
  const double sense = bulge > 0 ? 1 : -1;
  return Ellipse{centre, u, {-sense * u.y, sense * u.x}, 0, std::fabs(angle)};
}

Shape moved(const Shape& shape, const Affine& affine) {
  if (const Line* line = std::get_if<Line>(&shape)) return Line{affine(line->from), affine(line->to)};
  if (const Ellipse* e = std::get_if<Ellipse>(&shape))
    return Ellipse{affine(e->centre), affine.turned(e->u), affine.turned(e->v), e->begin, e->end};
  Spline spline = std::get<Spline>(shape);
  for (Point& p : spline.points) p = affine(p);
  return spline;
}

std::string_view flaw_of(const Spline& s) {
  constexpr int highest_degree = 25;
  if (s.degree < 1 || s.degree > highest_degree) return "its degree is out of range";
  const auto degree = static_cast<std::size_t>(s.degree);
  if (s.points.size() < degree + 1) return "it has too few control points";
  if (s.knots.size() != s.points.size() + degree + 1) return "it has the wrong number of knots";
  if (!std::is_sorted(s.knots.begin(), s.knots.end())) return "its knots are not in order";
  if (!(s.knots[degree] < s.knots[s.points.size()])) return "its knots span no range";
  if (s.weights.size() != s.points.size()) return "it does not have a weight for each control point";
  if (std::any_of(s.weights.begin(), s.weights.end(), [](double w) { return !(w > 0); }))
    return "a weight is not above 0";
  return {};
}

/// De Boor, in homogeneous coordinates.
Point point_at(const Spline& s, double t) {
  struct Weighted {
    double x, y, w;
  };
  const auto degree = static_cast<std::size_t>(s.degree);
  const auto after = std::upper_bound(s.knots.begin() + s.degree,
                                      s.knots.begin() + static_cast<std::ptrdiff_t>(s.points.size()), t);
  auto span = static_cast<std::size_t>(after - s.knots.begin()) - 1;
  while (span > degree && s.knots[span] == s.knots[span + 1]) --span;  // skips spans of length 0
  std::array<Weighted, 26> d{};
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t from = span - degree + i;
    const double w = s.weights[from];
    d[i] = {s.points[from].x * w, s.points[from].y * w, w};
  }
  for (std::size_t level = 1; level <= degree; ++level)
    for (std::size_t i = degree; i >= level; --i) {
      const std::size_t low = span - degree + i;
      const double width = s.knots[low + degree - level + 1] - s.knots[low];
      const double part = width > 0 ? (t - s.knots[low]) / width : 0;
      d[i] = {d[i - 1].x + (d[i].x - d[i - 1].x) * part, d[i - 1].y + (d[i].y - d[i - 1].y) * part,
              d[i - 1].w + (d[i].w - d[i - 1].w) * part};
    }
  return {d[degree].x / d[degree].w, d[degree].y / d[degree].w};
}

void draw(const Shape& shape, const Tolerance& tolerance, std::vector<Curve>& curves) {
  if (const Line* line = std::get_if<Line>(&shape)) return line_to(line->to, curves, line->from);
  if (const Ellipse* ellipse = std::get_if<Ellipse>(&shape)) return draw_ellipse(*ellipse, tolerance, curves);
  draw_spline(std::get<Spline>(shape), tolerance, curves);
}

}  // namespace hw::drawing
