#include "core/drawing/tool_path.h"

#include <algorithm>
#include <cmath>

namespace hw::drawing {
namespace {

/// Whether c continues the line from a to b: off it by at most a millionth of the way.
bool straight_on(Point3 a, Point3 b, Point3 c) {
  const Point3 u = b - a, v = c - b;
  const double along = dot(u, v);
  const Point3 aside{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  return along > 0 && dot(aside, aside) <= 1e-12 * along * along;
}

/// Fraction along a line, 0 to 1, of its point nearest to p.
double nearest_on(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  return square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
}

/// The point at a fraction along a line's projection, in which its far half is shorter than its near one.
Point3 on_line(Point3 a, Point3 b, double along_px, const PathView& view) {
  const double at_a = view.projection().depth(a), at_b = view.projection().depth(b);
  return a + (b - a) * (along_px * at_a / ((1 - along_px) * at_b + along_px * at_a));
}

}  // namespace

void ToolPath::go(Point3 from, Point3 to, bool tool_on, int source, int pass) {
  (tool_on ? way_on : way_off) += length(to - from);
  bounds.add(from), bounds.add(to);
  const bool joins = !points.empty() && points.back() == from;
  if (!joins) points.push_back(from);
  const bool same_run = joins && !runs.empty() && runs.back().tool_on == tool_on &&
                        runs.back().source == source && runs.back().pass == pass;
  if (!same_run) {
    runs.push_back({points.size() - 1, 1, tool_on, source, pass});
  } else if (runs.back().size >= 2 && straight_on(points[points.size() - 2], from, to)) {
    points.back() = to;
    return;
  }
  points.push_back(to);
  ++runs.back().size;
}

std::optional<PathHit> nearest(const ToolPath& path, const PathView& view, Point px, double within_px) {
  std::optional<PathHit> best;
  double least = within_px;
  for (std::size_t r = 0; r < path.runs.size(); ++r) {
    const ToolPath::Run& run = path.runs[r];
    Point a = view.to_px(path.points[run.first]);
    for (std::size_t i = run.first + 1; i < run.first + run.size; ++i) {
      const Point b = view.to_px(path.points[i]);
      const bool far = std::min(a.x, b.x) > px.x + least || std::max(a.x, b.x) < px.x - least ||
                       std::min(a.y, b.y) > px.y + least || std::max(a.y, b.y) < px.y - least;
      if (!far) {
        const double t = nearest_on(a, b, px);
        const double distance = std::hypot(a.x + t * (b.x - a.x) - px.x, a.y + t * (b.y - a.y) - px.y);
        if (distance <= least)
          least = distance, best = PathHit{r, on_line(path.points[i - 1], path.points[i], t, view)};
      }
      a = b;
    }
  }
  return best;
}

namespace {

/// Stops once it has more than `most_points`.
ToolPath with_gaps_of(double gap, const ToolPath& path, std::size_t most_points) {
  ToolPath few;
  Point3 at;
  std::size_t end = path.points.size();  // of the run before; of none yet
  for (const ToolPath::Run& run : path.runs) {
    if (run.first != end) at = path.points[run.first];
    end = run.first + run.size - 1;
    for (std::size_t i = run.first + 1; i <= end; ++i) {
      if (length(path.points[i] - at) < gap) continue;
      few.go(at, path.points[i], run.tool_on, -1);
      at = path.points[i];
    }
    if (few.points.size() > most_points) break;
  }
  return few;
}

}  // namespace

ToolPath coarser(const ToolPath& path, std::size_t most_points) {
  double gap = length(path.bounds.size()) / 1000;
  for (;; gap *= 2) {
    ToolPath few = with_gaps_of(gap, path, most_points);
    if (few.points.size() <= most_points || !(gap > 0)) return few;
  }
}

ToolPath flattened(const ToolPath& path, const Projection& projection) {
  ToolPath flat = path;
  flat.bounds = {};
  for (Point3& p : flat.points) flat.bounds.add(p = projection.on_plane(p));
  return flat;
}

}  // namespace hw::drawing
