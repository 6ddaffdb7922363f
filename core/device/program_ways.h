#pragma once
// The places where the motions of a known program can come to rest by themselves. A motion that rests
// elsewhere was cut short, whatever the controller reports. Pure.
#include <array>
#include <vector>

#include "core/device/catalog.h"
#include "core/sequence/sequence.h"

namespace hw {

struct AxisWays {
  bool known = false;  ///< false: it may rest anywhere
  std::vector<Steps> places;
  /// The shortest distance that a command of the program moves the axis to either side; 0: no command does.
  Steps shortest_minus{}, shortest_plus{};
};
using ProgramWays = std::array<AxisWays, max_axes>;

/// Of a program whose text consists of these steps.
[[nodiscard]] ProgramWays ways_of(const sequence::Sequence& sequence, const Catalog& catalog);

/// The axis came to rest at `at`, and none of the commands can have taken it there whole. `from`: where it
/// was seen at rest before. Judged only if all commands name places, or all go to the same side.
[[nodiscard]] bool was_cut_short(const AxisWays& ways, Steps from, Steps at);

}  // namespace hw
