#include "core/sequence/speed_stairs.h"

#include <fmt/core.h>

namespace hw::sequence {

static bool lies_behind(double place, double before, Sign way) {
  return way == Sign::plus ? place > before : place < before;
}

Sign direction_of(const SpeedStairs& s) {
  return !s.stairs.empty() && s.stop_at < s.stairs.front().until ? Sign::minus : Sign::plus;
}

std::string why_no_way(const SpeedStairs& s, std::optional<double> from) {
  if (s.stairs.empty()) return "there is no stair.";
  if (from == s.stop_at) return "the stop position is where the axis stands.";
  const Sign way = !from ? direction_of(s) : s.stop_at > *from ? Sign::plus : Sign::minus;
  std::optional<double> before = from;
  for (std::size_t i = 0; i < s.stairs.size(); ++i) {
    const double until = s.stairs[i].until;
    if (before && !lies_behind(until, *before, way))
      return fmt::format("stair {}: {} does not lie on the way from {} to {}.", i + 1, until, *before,
                         s.stop_at);
    before = until;
  }
  if (!lies_behind(s.stop_at, *before, way))
    return fmt::format("the last stair ends at {1}, past the stop position {0}.", s.stop_at, *before);
  return {};
}

}  // namespace hw::sequence
