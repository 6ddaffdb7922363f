#pragma once
// Exact curves of a drawing file. Each keeps its type under shift, turn, scale and mirror, so that nested
// blocks lose nothing; they become lines and arcs only at the end.
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/drawing/drawing.h"

namespace hw::drawing {

/// (x, y) goes to (a x + c y + e, b x + d y + f).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  [[nodiscard]] Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// Maps a direction: without the shift.
  [[nodiscard]] Point turned(Point p) const { return {a * p.x + c * p.y, b * p.x + d * p.y}; }
  /// First `inner`, then this.
  [[nodiscard]] Affine after(const Affine& inner) const;
  /// The point that maps to `p`. Not for a singular map.
  [[nodiscard]] Point undone(Point p) const {
    const double x = p.x - e, y = p.y - f, area = a * d - b * c;
    return {(d * x - c * y) / area, (a * y - b * x) / area};
  }
  static Affine mirror_x() { return {-1, 0, 0, 1, 0, 0}; }
};

struct Line {
  Point from, to;
};
/// centre + u cos t + v sin t, for t from `begin` to `end` (radians); a circle where u and v are alike.
struct Ellipse {
  Point centre, u, v;
  double begin = 0, end = 0;
};
/// A rational B-spline.
struct Spline {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Point> points;
  std::vector<double> weights;
};
using Shape = std::variant<Line, Ellipse, Spline>;

/// Largest distance of a chord from its curve, in the unit of the drawing.
struct Tolerance {
  double chord = 0.01;
};

/// Part of a circle.
Ellipse arc_of(Point centre, double radius, double begin_degrees, double end_degrees);
/// From one point of a polyline to the next; `bulge`: tangent of a quarter of the arc's angle. A line if that
/// is 0 or negligible.
Shape bulged(Point from, Point to, double bulge);
Shape moved(const Shape& shape, const Affine& affine);
/// The error in the spline's numbers; empty: none.
std::string_view flaw_of(const Spline& spline);
Point point_at(const Spline& spline, double t);
/// Appends the shape to `curves` as lines and arcs.
void draw(const Shape& shape, const Tolerance& tolerance, std::vector<Curve>& curves);

}  // namespace hw::drawing
