#pragma once
// Whether stairs of speeds are a way that an axis can go.
#include <optional>
#include <string>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Which way they go. Of none: plus.
Sign direction_of(const SpeedStairs& stairs);
/// Why its places do not lie one behind the other, on to where it stops: "stair 2: 15 does not lie on the way
/// from 20 to 90." Empty: they do. `from`: where the axis stands; none: nobody knows.
std::string why_no_way(const SpeedStairs& stairs, std::optional<double> from);

}  // namespace hw::sequence
