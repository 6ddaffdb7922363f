#include "core/drawing/tool_path.h"

#include <algorithm>
#include <cmath>

namespace hw::drawing {
namespace {

/// Whether c goes on from b as b came from a: beside the line by no more than a millionth of the way.
bool straight_on(Point a, Point b, Point c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
  const double along = ux * vx + uy * vy;
  return along > 0 && std::fabs(ux * vy - uy * vx) <= 1e-6 * along;
}

/// The point of a line that lies nearest to p.
Point nearest_on(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  if (square == 0) return a;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
  return {a.x + t * dx, a.y + t * dy};
}

}  // namespace

void ToolPath::go(Point from, Point to, bool tool_on, int source) {
  (tool_on ? way_on : way_off) += std::hypot(to.x - from.x, to.y - from.y);
  bounds.add(from), bounds.add(to);
  const bool joins = !points.empty() && points.back() == from;
  if (!joins) points.push_back(from);
  const bool same_run =
      joins && !runs.empty() && runs.back().tool_on == tool_on && runs.back().source == source;
  if (!same_run) {
    runs.push_back({points.size() - 1, 1, tool_on, source});
  } else if (runs.back().size >= 2 && straight_on(points[points.size() - 2], from, to)) {
    points.back() = to;
    return;
  }
  points.push_back(to);
  ++runs.back().size;
}

PathView::PathView(const Box& box, double width_px, double height_px, bool equal)
    : width_px_(std::max(width_px, 1.0)), height_px_(std::max(height_px, 1.0)) {
  constexpr double air = 0.06;
  if (box.empty) return;
  centre_ = {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  const double whole = std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1e-9});
  const auto shown = [&](double size, double px) {
    return std::max(size, equal ? 1e-9 : whole * 1e-3) * (1 + 2 * air) / px;
  };
  per_px_ = {shown(box.high.x - box.low.x, width_px_), shown(box.high.y - box.low.y, height_px_)};
  if (equal) per_px_.x = per_px_.y = std::max(per_px_.x, per_px_.y);
}

void PathView::pan(double right_px, double down_px) {
  centre_.x -= right_px * per_px_.x;
  centre_.y += down_px * per_px_.y;
}

void PathView::zoom(Point about_px, double factor) {
  const Point kept = from_px(about_px);
  const double least = 1e-12 * std::max({std::fabs(centre_.x), std::fabs(centre_.y), 1e-3});
  const double smaller = std::min(per_px_.x, per_px_.y) / factor;
  if (!(factor > 0) || smaller < least || std::max(per_px_.x, per_px_.y) / factor > 1e12) return;
  per_px_ = {per_px_.x / factor, per_px_.y / factor};
  const Point there = from_px(about_px);
  centre_ = {centre_.x + kept.x - there.x, centre_.y + kept.y - there.y};
}

void PathView::resize(double width_px, double height_px) {
  const double smaller = std::min(std::max(width_px, 1.0) / width_px_, std::max(height_px, 1.0) / height_px_);
  width_px_ = std::max(width_px, 1.0), height_px_ = std::max(height_px, 1.0);
  per_px_ = {per_px_.x / smaller, per_px_.y / smaller};
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
        const Point on = nearest_on(a, b, px);
        const double distance = std::hypot(on.x - px.x, on.y - px.y);
        if (distance <= least) least = distance, best = PathHit{r, view.from_px(on)};
      }
      a = b;
    }
  }
  return best;
}

}  // namespace hw::drawing
