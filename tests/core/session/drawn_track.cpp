#include "tests/core/session/drawn_track.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace hw {
namespace {

using drawing::Point;

double beside(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squares = dx * dx + dy * dy;
  const double t = squares > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squares, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double nearest_of(const std::vector<std::pair<Point, Point>>& lines, Point p) {
  double nearest = 1e9;
  for (const auto& [from, to] : lines) nearest = std::min(nearest, beside(p, from, to));
  return nearest;
}

}  // namespace

void DrawnTrack::expect_every_vertex() const {
  for (const drawing::Chain& chain : made.chains)
    for (const drawing::Curve& curve : chain.curves)
      for (const drawing::Point end : {curve.from, curve.to})
        EXPECT_LE(nearest_pass(end, curve.length() < 1 / per_unit), 1 / per_unit) << end.x << ", " << end.y;
}

void DrawnTrack::expect_nothing_beside() const {
  constexpr std::size_t looks = 1000;
  const std::vector<std::pair<drawing::Point, drawing::Point>> lines = drawn_lines();
  std::size_t n = 0, seen = 0;
  // Some outputs are on when the power comes, until the first step switches them off.
  while (n < rehearsal.track.size() && rehearsal.track[n].position == rehearsal.track[0].position) ++n;
  const std::size_t every = std::max<std::size_t>(rehearsal.track.size() / looks, 1);
  for (; n < rehearsal.track.size(); n += every) {
    if (!down(n)) continue;
    ++seen;
    ASSERT_LE(nearest_of(lines, at(n)), made.tolerance + 1 / per_unit)
        << n << ": " << at(n).x << ", " << at(n).y;
  }
  if (made.drawn > 0) {
    EXPECT_GT(seen, 100u);
  }
}

drawing::Point DrawnTrack::at(std::size_t n) const {
  const auto& p = rehearsal.track[n].position;
  return {static_cast<double>(p[0]) / per_unit, static_cast<double>(p[1]) / per_unit};
}

/// With the tool down; for a dot that may take no time.
double DrawnTrack::nearest_pass(drawing::Point to, bool dot) const {
  double nearest = 1e9;
  for (std::size_t n = 1; n < rehearsal.track.size(); ++n)
    if (dot || down(n) || down(n - 1)) nearest = std::min(nearest, beside(to, at(n - 1), at(n)));
  return nearest;
}

std::vector<std::pair<drawing::Point, drawing::Point>> DrawnTrack::drawn_lines() const {
  std::vector<std::pair<drawing::Point, drawing::Point>> lines;
  for (const drawing::Chain& chain : made.chains)
    for (const drawing::Curve& curve : chain.curves) {
      drawing::Point from = curve.from;
      drawing::chords(curve, 0.0005, [&](drawing::Point to) {
        lines.emplace_back(from, to);
        from = to;
      });
    }
  return lines;
}

}  // namespace hw
