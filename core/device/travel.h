#pragma once
// The user's limits of an axis: soft limits that the console enforces, with or without limits of the
// controller.
#include <cstdint>

#include "core/base/units.h"

namespace hw {

/// Absolute, in the unit that the axis counts. A side without a limit is not checked.
struct Travel {
  bool has_minus = false, has_plus = false;
  Steps minus{}, plus{};
  bool in_counts = false;  ///< set while the loop was closed: in encoder counts, not in pulses

  [[nodiscard]] bool any() const { return has_minus || has_plus; }
  [[nodiscard]] bool has(Sign side) const { return side == Sign::minus ? has_minus : has_plus; }
  [[nodiscard]] Steps end(Sign side) const { return side == Sign::minus ? minus : plus; }
  /// How far `place` lies past the limit on that side; 0 or less: inside, or no limit there.
  [[nodiscard]] Steps past(Sign side, Steps place) const {
    if (!has(side)) return Steps(0);
    return side == Sign::minus ? minus - place : place - plus;
  }
  bool operator==(const Travel&) const = default;
};

/// A place outside the limits of its axis.
struct PastTravel {
  AxisId axis;
  Sign side = Sign::plus;  ///< the limit that `place` is past
  Steps place{};
  Steps nearest{};  ///< the limit
  int row = -1;     ///< row of a list, from 0; -1: not in a list
  enum class Of : std::uint8_t {
    target,
    backlash,  ///< a move to a target inside would go there first, to take up backlash
    jog,       ///< `place` is where the axis stands
    text       ///< a raw text, which is sent anyway
  };
  Of of = Of::target;
  bool operator==(const PastTravel&) const = default;
};

}  // namespace hw
