#pragma once
// Where the user lets an axis go: soft limits of the console's own, whatever the controller has.
#include <optional>

#include "core/base/units.h"

namespace hw {

/// Absolute, in what the axis counts. An end that is not set bounds nothing.
struct Travel {
  bool has_minus = false, has_plus = false;
  Steps minus{}, plus{};
  bool in_counts = false;  ///< set while its loop was closed: they are no pulses

  [[nodiscard]] bool any() const { return has_minus || has_plus; }
  [[nodiscard]] bool has(Sign side) const { return side == Sign::minus ? has_minus : has_plus; }
  [[nodiscard]] Steps end(Sign side) const { return side == Sign::minus ? minus : plus; }
  /// How far `place` lies outside on that side; 0 or less: it does not, or that side has no end.
  [[nodiscard]] Steps past(Sign side, Steps place) const {
    if (!has(side)) return Steps(0);
    return side == Sign::minus ? minus - place : place - plus;
  }
  bool operator==(const Travel&) const = default;
};

/// A place that lies outside the travel of its axis.
struct PastTravel {
  AxisId axis;
  Sign side = Sign::plus;  ///< past which end
  Steps place{};
  Steps nearest{};  ///< that end
  int row = -1;     ///< of a list, from 0
  bool operator==(const PastTravel&) const = default;
};

}  // namespace hw
