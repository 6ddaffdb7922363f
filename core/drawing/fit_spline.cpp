#include "core/drawing/fit_spline.h"

#include <algorithm>
#include <cmath>

namespace hw::drawing {
namespace {

Point plus(Point p, Point q, double times = 1) { return {p.x + q.x * times, p.y + q.y * times}; }
Point minus(Point p, Point q) { return plus(p, q, -1); }
double long_as(Point p) { return std::hypot(p.x, p.y); }
double area_of(Point p, Point q) { return std::fabs(p.x * q.y - p.y * q.x); }

/// The direction at an end from its two nearest chords, extrapolated beyond the end (Akima).
Point leaving(Point first, Point second) {
  const Point before = minus(plus(first, first), second), earlier = minus(plus(before, before), first);
  const double bends_before = area_of(earlier, before), bends_behind = area_of(first, second);
  const double all = bends_before + bends_behind;
  const double share = all > 0 ? bends_before / all : 0.5;
  return plus(plus({}, before, 1 - share), first, share);
}

class Interpolating {
 public:
  explicit Interpolating(const FitPoints& fit) : fit_(fit) {
    for (std::size_t i = 0; i + 1 < fit.points.size(); ++i) {
      chords_.push_back(minus(fit.points[i + 1], fit.points[i]));
      lengths_.push_back(long_as(chords_.back()));
    }
  }

  Spline run() {
    set_ends();
    solve();
    Spline s;
    double at = 0;
    s.points.push_back(fit_.points.front());
    s.knots.assign(4, 0.0);
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      const double third = lengths_[i] / 3;
      s.points.push_back(plus(fit_.points[i], ways_[i], third));
      s.points.push_back(plus(fit_.points[i + 1], ways_[i + 1], -third));
      s.points.push_back(fit_.points[i + 1]);
      s.knots.insert(s.knots.end(), 3, at += lengths_[i]);
    }
    s.knots.push_back(at);
    s.weights.assign(s.points.size(), 1.0);
    return s;
  }

 private:
  [[nodiscard]] static Point unit(Point p) {
    const double length = long_as(p);
    return length > 0 ? Point{p.x / length, p.y / length} : p;
  }
  void set_ends() {
    ways_.resize(fit_.points.size());
    const std::size_t last = chords_.size() - 1;
    Point &first = ways_.front(), &end = ways_.back();
    if (fit_.closed) {
      first = end = unit(plus(unit(chords_.front()), unit(chords_.back())));
      return;
    }
    first = unit(long_as(fit_.start) > 0 ? fit_.start : leaving(chords_[0], chords_[1]));
    end = unit(long_as(fit_.end) > 0 ? fit_.end : leaving(chords_[last], chords_[last - 1]));
  }
  /// Solves for the inner directions so that the curvature is continuous: a tridiagonal system.
  void solve() {
    const std::size_t n = ways_.size();
    std::vector<double> next(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double a = 1 / lengths_[i - 1], c = 1 / lengths_[i];
      const Point right = plus(plus({}, chords_[i - 1], 3 * a * a), chords_[i], 3 * c * c);
      const double pivot = 2 * (a + c) - a * next[i - 1];
      next[i] = c / pivot;
      ways_[i] = plus({}, plus(right, ways_[i - 1], -a), 1 / pivot);
    }
    for (std::size_t i = n - 1; i-- > 1;) ways_[i] = plus(ways_[i], ways_[i + 1], -next[i]);
  }

  const FitPoints& fit_;
  std::vector<Point> chords_, ways_;  ///< ways: directions along the curve at each point
  std::vector<double> lengths_;
};

}  // namespace

std::optional<Shape> through(FitPoints fit) {
  std::vector<Point>& points = fit.points;
  if (fit.closed && !points.empty()) points.push_back(points.front());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return std::nullopt;
  const bool has_end_directions = long_as(fit.start) > 0 && long_as(fit.end) > 0;
  if (points.size() == 2 && (!has_end_directions || fit.closed)) return Line{points[0], points[1]};
  return Interpolating(fit).run();
}

}  // namespace hw::drawing
