#pragma once
// A sequence whose axes are controllers of one axis each on one wire (two DMX on a bus): what each of them
// does, act by act, all together. They begin a move together, one command on the wire apart, and each goes
// at its own pace.
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/pieces.h"
#include "core/sequence/sequence.h"

namespace hw {

/// Their axes, by their ids, as if they were of one controller; inputs and outputs are those of the first.
/// None: these have more than one axis, or no id.
[[nodiscard]] std::optional<Catalog> catalog_together(std::span<const Catalog* const> members);

/// For each axis of the sequence, in its order, what its controller does; all have equally many acts. `bus`
/// is of catalog_together(). From where the tool was up last before `from_step`. The fault names the step.
[[nodiscard]] Result<std::vector<Pieces>> pieces_together(const sequence::Sequence& sequence,
                                                          const Catalog& bus, int from_step);

/// How long each piece takes at least: its motions with their ramps, and delays, without what a wire adds.
/// Empty: some go at the controllers' own speed. What no step says of ramps is taken as from the factory.
[[nodiscard]] std::vector<double> least_seconds(const std::vector<Pieces>& parts, const Catalog& bus);

}  // namespace hw
