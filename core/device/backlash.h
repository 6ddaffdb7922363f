#pragma once
// Play between motor and table, taken up by coming to every target from the same side.
#include <optional>

#include "core/base/units.h"

namespace hw {

struct Backlash {
  Steps by{};  ///< how far past its target a move goes that would end the other way; 0: not taken up
  Sign last = Sign::plus;  ///< the way in which every move ends
  bool operator==(const Backlash&) const = default;
};

}  // namespace hw
