#pragma once
// Backlash between motor and table, taken up by approaching every target from the same side.
#include <optional>

#include "core/base/units.h"

namespace hw {

struct Backlash {
  Steps by{};              ///< how far a move in the other direction goes past its target first; 0: off
  Sign last = Sign::plus;  ///< the direction in which every move ends
  bool operator==(const Backlash&) const = default;
};

}  // namespace hw
