#pragma once
// Whole steps from a calculated place or distance.
#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace hw {

/// Clamped to far beyond any axis, so that the conversion, and the sum of a few results, is defined.
inline Steps rounded_steps(double place) {
  constexpr double furthest = 1e15;
  return Steps(std::llround(std::clamp(place, -furthest, furthest)));
}

}  // namespace hw
