#pragma once
// Checks whether an axis can run SpeedStairs.
#include <optional>
#include <string>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Their direction; plus without stairs.
Sign direction_of(const SpeedStairs& stairs);
/// Why the places up to the stop are not in order: "stair 2: 15 does not lie on the way from 20 to 90."
/// Empty: they are. `from`: position of the axis; none: unknown.
std::string why_no_way(const SpeedStairs& stairs, std::optional<double> from);

}  // namespace hw::sequence
