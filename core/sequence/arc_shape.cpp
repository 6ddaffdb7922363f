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

// Between its ends an arc has extremes only where it crosses an axis through its centre.
ArcReach reach_of(const Arc& arc, double x, double y) {
  ArcReach reach{x, x, y, y};
  const auto take = [&reach](double to_x, double to_y) {
    reach.left = std::min(reach.left, to_x), reach.right = std::max(reach.right, to_x);
    reach.below = std::min(reach.below, to_y), reach.above = std::max(reach.above, to_y);
  };
  const auto [end_x, end_y] = end_of(arc, x, y);
  take(end_x, end_y);
  const double radius = std::hypot(x - arc.x, y - arc.y), begin = std::atan2(y - arc.y, x - arc.x);
  constexpr double whole = 4 * quarter;  // more turns reach no further
  const double turn = std::clamp(radians(arc), -whole, whole);
  const double low = std::min(begin, begin + turn), high = std::max(begin, begin + turn);
  const double first = std::ceil(low / quarter);
  for (int i = 0; i <= 4 && first + i <= high / quarter; ++i)
    take(arc.x + radius * std::cos((first + i) * quarter), arc.y + radius * std::sin((first + i) * quarter));
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

std::optional<ContourEnd> end_of(const Contour& contour) {
  ContourEnd end{contour.x, contour.y};
  bool any = false;
  const auto go = [&](double x, double y, double way_x, double way_y) {
    const double way = std::hypot(way_x, way_y);
    if (way > 0) end.dx = way_x / way, end.dy = way_y / way, any = true;
    end.x = x, end.y = y;
  };
  for (const Step& step : contour.steps) {
    if (step.skipped) continue;
    if (const auto* move = std::get_if<Move>(&step.body)) {
      const double x = move->to[ix(contour.plane.right)].value_or(end.x);
      const double y = move->to[ix(contour.plane.up)].value_or(end.y);
      go(x, y, x - end.x, y - end.y);
    }
    if (const auto* arc = std::get_if<Arc>(&step.body); arc && arc->degrees != 0) {
      const auto [x, y] = end_of(*arc, end.x, end.y);
      const double sense = arc->degrees > 0 ? 1 : -1;
      go(x, y, -sense * (y - arc->y), sense * (x - arc->x));
    }
  }
  return any ? std::optional(end) : std::nullopt;
}

std::optional<double> runs_on_by(const Contour& contour, const Speeds& held) {
  if (!contour.ends_ramped) return 0;
  const double speed = contour.own && contour.own->high > 0 ? contour.own->high : held.high;
  if (speed <= 0 || held.ramp_ms <= 0 || held.high <= held.low) return std::nullopt;
  const double acceleration = (held.high - held.low) / (held.ramp_ms / 1000);
  const double base = std::min(held.low, speed);
  return (speed * speed - base * base) / (2 * acceleration);
}

}  // namespace hw::sequence
