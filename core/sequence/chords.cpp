#include "core/sequence/chords.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw::sequence {

Chords::Chords(double dx, double dy, double degrees, double tolerance)
    : radius_(std::hypot(dx, dy)), begin_(std::atan2(dy, dx)), turn_(degrees / 180 * std::numbers::pi) {
  constexpr double most = 1e6;
  const double widest = 2 * std::acos(std::clamp(1 - tolerance / radius_, 0.0, 1.0));
  const double wanted = widest > 0 ? std::ceil(std::fabs(turn_) / widest) : most;
  count_ = radius_ > 0 ? static_cast<int>(std::clamp(wanted, 1.0, most)) : 1;
}

std::pair<double, double> Chords::end(int n) const {
  const double angle = begin_ + turn_ * n / count_;
  return {radius_ * std::cos(angle), radius_ * std::sin(angle)};
}

}  // namespace hw::sequence
