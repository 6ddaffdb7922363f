#include "core/devices/pmx_4ex_sa/arc_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw::pmx_4ex_sa {
namespace {

constexpr double quarter = std::numbers::pi / 2;

struct Span {
  double low, high;
  void take(double place) { low = std::min(low, place), high = std::max(high, place); }
};

/// `turn` in radians, counterclockwise. Between its ends an arc turns back only where it crosses an axis of
/// its centre.
std::vector<AxisTarget> reaches(const Snapshot& now, std::int64_t centre_x, std::int64_t centre_y,
                                double turn) {
  const auto from_x = static_cast<double>(now.axes[0].commanded().value);
  const auto from_y = static_cast<double>(now.axes[1].commanded().value);
  const auto cx = static_cast<double>(centre_x), cy = static_cast<double>(centre_y);
  const double radius = std::hypot(from_x - cx, from_y - cy);
  const double begin = std::atan2(from_y - cy, from_x - cx);
  Span x{from_x, from_x}, y{from_y, from_y};
  const auto take = [&](double angle) {
    x.take(cx + radius * std::cos(angle));
    y.take(cy + radius * std::sin(angle));
  };
  take(begin + turn);
  const double low = std::min(begin, begin + turn), high = std::max(begin, begin + turn);
  for (double k = std::ceil(low / quarter), last = std::min(k + 4, high / quarter); k <= last; ++k)
    take(k * quarter);
  std::vector<AxisTarget> places;
  for (const auto& [axis, span] : {std::pair(AxisId{0}, x), std::pair(AxisId{1}, y)})
    for (const double place : {span.low, span.high}) places.push_back({axis, Steps(std::llround(place))});
  return places;
}

}  // namespace

std::vector<AxisTarget> arc_reaches(const Snapshot& now, const std::vector<std::int64_t>& values) {
  if (values.size() < 3) return {};
  return reaches(now, values[0], values[1], static_cast<double>(values[2]) / 1000 * std::numbers::pi / 180);
}

}  // namespace hw::pmx_4ex_sa
