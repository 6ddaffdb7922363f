#include "core/motion/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw::motion {

Path Path::along(std::size_t axis, Sign way, std::int64_t length) {
  Offsets to{};
  to.at(axis) = factor(way) * length;
  return line(to);
}

Path Path::line(const Offsets& to) {
  Path p;
  p.to_ = to;
  double squares = 0;
  for (const std::int64_t d : to) {
    p.steps_ = std::max(p.steps_, std::abs(d));
    squares += static_cast<double>(d) * static_cast<double>(d);
  }
  if (p.steps_ > 0) p.pulses_per_step_ = std::sqrt(squares) / static_cast<double>(p.steps_);
  return p;
}

Path Path::arc(std::size_t x_axis, std::size_t y_axis, double from_x, double from_y, double sweep) {
  Path p;
  p.arc_ = true, p.x_ = x_axis, p.y_ = y_axis;
  p.from_x_ = from_x, p.from_y_ = from_y, p.sweep_ = sweep;
  p.radius_ = std::hypot(from_x, from_y);
  p.begin_ = std::atan2(from_y, from_x);
  const double length = p.radius_ * std::abs(sweep);
  p.steps_ = std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil(length)), 1);
  p.pulses_per_step_ = length / static_cast<double>(p.steps_);
  return p;
}

double Path::angle(double step) const { return begin_ + sweep_ * step / static_cast<double>(steps_); }

std::int64_t Path::offset(std::size_t axis, std::int64_t step) const {
  if (arc_) {
    if (axis == x_) return std::llround(radius_ * std::cos(angle(static_cast<double>(step))) - from_x_);
    if (axis == y_) return std::llround(radius_ * std::sin(angle(static_cast<double>(step))) - from_y_);
    return 0;
  }
  const std::int64_t d = to_[axis];
  if (d == 0) return 0;
  if (std::abs(d) == steps_) return d > 0 ? step : -step;
  __extension__ using Wide = __int128;
  const Wide nearest = (Wide(std::abs(d)) * step * 2 + steps_) / (Wide(2) * steps_);
  return static_cast<std::int64_t>(d > 0 ? nearest : -nearest);
}

double Path::exact(std::size_t axis, double step) const {
  if (arc_ && axis == x_) return radius_ * std::cos(angle(step)) - from_x_;
  if (arc_ && axis == y_) return radius_ * std::sin(angle(step)) - from_y_;
  return arc_ || steps_ == 0 ? 0 : static_cast<double>(to_[axis]) * (step / static_cast<double>(steps_));
}

bool Path::moves(std::size_t axis) const { return arc_ ? axis == x_ || axis == y_ : to_[axis] != 0; }

std::int64_t Path::next_turn(std::int64_t step) const {
  if (!arc_) return steps_;
  // Quarter turns of the circle, in the direction of travel.
  constexpr double quarter = std::numbers::pi / 2;
  const double way = sweep_ >= 0 ? 1 : -1;
  const double here = way * angle(static_cast<double>(step));
  double next = (std::floor(here / quarter) + 1) * quarter;
  for (int i = 0; i < 3; ++i, next += quarter) {
    const double at = (next - way * begin_) / std::abs(sweep_) * static_cast<double>(steps_);
    const auto turn = static_cast<std::int64_t>(std::llround(at));
    if (turn > step) return std::min(turn, steps_);
  }
  return steps_;
}

int Path::direction(std::size_t axis, std::int64_t step) const {
  const std::int64_t ahead = arc_ ? offset(axis, next_turn(step)) - offset(axis, step) : to_[axis];
  return ahead > 0 ? 1 : ahead < 0 ? -1 : 0;
}

std::optional<std::int64_t> Path::first_at(std::size_t axis, std::int64_t step, std::int64_t wanted) const {
  const std::int64_t way = direction(axis, step);
  std::int64_t low = step, high = next_turn(step);
  if (way == 0 || way * offset(axis, high) < way * wanted) return std::nullopt;
  if (way * offset(axis, low) >= way * wanted) return low + 1 <= high ? low + 1 : high;
  if (!arc_ && std::abs(to_[axis]) == steps_) return std::abs(wanted);
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (way * offset(axis, middle) >= way * wanted ? high : low) = middle;
  }
  return high;
}

double Path::share(std::size_t axis, double step) const {
  if (steps_ == 0) return 0;
  if (!arc_) return static_cast<double>(to_[axis]) / static_cast<double>(steps_) / pulses_per_step_;
  const double way = sweep_ >= 0 ? 1 : -1;
  if (axis == x_) return -way * std::sin(angle(step));
  return axis == y_ ? way * std::cos(angle(step)) : 0;
}

}  // namespace hw::motion
