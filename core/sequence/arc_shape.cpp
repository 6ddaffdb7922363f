#include "core/sequence/arc_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/index.h"

namespace hw::sequence {

static constexpr double quarter = std::numbers::pi / 2;

static double radians(const Arc& arc) { return arc.degrees / 180 * std::numbers::pi; }

std::pair<double, double> end_of(const Arc& arc, double x, double y) {
  if (std::fmod(arc.degrees, 360) == 0) return {x, y};
  const double turn = radians(arc), dx = x - arc.x, dy = y - arc.y;
  return {arc.x + dx * std::cos(turn) - dy * std::sin(turn),
          arc.y + dx * std::sin(turn) + dy * std::cos(turn)};
}

// Between its ends it turns back only where it crosses an axis of its centre.
ArcReach reach_of(const Arc& arc, double x, double y) {
  ArcReach reach{x, x, y, y};
  const auto take = [&reach](double to_x, double to_y) {
    reach.left = std::min(reach.left, to_x), reach.right = std::max(reach.right, to_x);
    reach.below = std::min(reach.below, to_y), reach.above = std::max(reach.above, to_y);
  };
  const auto [end_x, end_y] = end_of(arc, x, y);
  take(end_x, end_y);
  const double radius = std::hypot(x - arc.x, y - arc.y), begin = std::atan2(y - arc.y, x - arc.x);
  const double low = std::min(begin, begin + radians(arc)), high = std::max(begin, begin + radians(arc));
  for (double k = std::ceil(low / quarter), last = std::min(k + 4, high / quarter); k <= last; ++k)
    take(arc.x + radius * std::cos(k * quarter), arc.y + radius * std::sin(k * quarter));
  return reach;
}

std::optional<std::pair<double, double>> sets_off(const Contour& contour) {
  for (const Step& step : contour.steps) {
    if (step.skipped) continue;
    if (const auto* move = std::get_if<Move>(&step.body)) {
      const auto along = [&](int axis, double from) { return move->to[ix(axis)].value_or(from) - from; };
      const double dx = along(contour.plane.right, contour.x), dy = along(contour.plane.up, contour.y);
      if (const double way = std::hypot(dx, dy); way > 0) return std::pair(dx / way, dy / way);
    }
    if (const auto* arc = std::get_if<Arc>(&step.body)) {
      const double rx = contour.x - arc->x, ry = contour.y - arc->y, radius = std::hypot(rx, ry);
      const double sense = arc->degrees > 0 ? 1 : -1;
      if (radius > 0 && arc->degrees != 0) return std::pair(-sense * ry / radius, sense * rx / radius);
    }
  }
  return std::nullopt;
}

}  // namespace hw::sequence
