#pragma once
// Where the tool of an emulated machine has been along a drawing, and whether it has done what was asked of
// it.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "core/device/language.h"
#include "core/session/conversion.h"

namespace hw {

struct DrawnTrack {
  /// Within one step, and with the tool down where it is more than a dot.
  void expect_every_vertex() const;
  /// With the tool down it stays within the tolerance and one step of the drawing.
  void expect_nothing_beside() const;

  static constexpr double per_unit = 200;
  Conversion made;
  Rehearsal rehearsal;
  int out = 0;  ///< of the tool, by its place in the catalog

 private:
  [[nodiscard]] drawing::Point at(std::size_t n) const;
  [[nodiscard]] bool down(std::size_t n) const { return (rehearsal.track[n].outputs >> out & 1u) != 0; }
  [[nodiscard]] double nearest_pass(drawing::Point to, bool dot) const;
  [[nodiscard]] std::vector<std::pair<drawing::Point, drawing::Point>> drawn_lines() const;
};

namespace drawn_track {

using drawing::Point;

inline double beside(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squares = dx * dx + dy * dy;
  const double t = squares > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squares, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

inline double nearest_of(const std::vector<std::pair<Point, Point>>& lines, Point p) {
  double nearest = 1e9;
  for (const auto& [from, to] : lines) nearest = std::min(nearest, beside(p, from, to));
  return nearest;
}

}  // namespace drawn_track

inline void DrawnTrack::expect_every_vertex() const {
  for (const drawing::Chain& chain : made.chains)
    for (const drawing::Curve& curve : chain.curves)
      for (const drawing::Point end : {curve.from, curve.to})
        EXPECT_LE(nearest_pass(end, curve.length() < 1 / per_unit), 1 / per_unit) << end.x << ", " << end.y;
}

inline void DrawnTrack::expect_nothing_beside() const {
  constexpr std::size_t looks = 1000;
  const std::vector<std::pair<drawing::Point, drawing::Point>> lines = drawn_lines();
  std::size_t n = 0, seen = 0;
  // Some outputs are on when the power comes, until the first step switches them off.
  while (n < rehearsal.track.size() && rehearsal.track[n].position == rehearsal.track[0].position) ++n;
  const std::size_t every = std::max<std::size_t>(rehearsal.track.size() / looks, 1);
  for (; n < rehearsal.track.size(); n += every) {
    if (!down(n)) continue;
    ++seen;
    ASSERT_LE(drawn_track::nearest_of(lines, at(n)), made.tolerance + 1 / per_unit)
        << n << ": " << at(n).x << ", " << at(n).y;
  }
  if (made.drawn > 0) {
    EXPECT_GT(seen, 100u);
  }
}

inline drawing::Point DrawnTrack::at(std::size_t n) const {
  const auto& p = rehearsal.track[n].position;
  return {static_cast<double>(p[0]) / per_unit, static_cast<double>(p[1]) / per_unit};
}

/// With the tool down; for a dot that may take no time.
inline double DrawnTrack::nearest_pass(drawing::Point to, bool dot) const {
  double nearest = 1e9;
  for (std::size_t n = 1; n < rehearsal.track.size(); ++n)
    if (dot || down(n) || down(n - 1)) nearest = std::min(nearest, drawn_track::beside(to, at(n - 1), at(n)));
  return nearest;
}

inline std::vector<std::pair<drawing::Point, drawing::Point>> DrawnTrack::drawn_lines() const {
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
