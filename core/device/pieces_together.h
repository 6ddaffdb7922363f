#pragma once
// A sequence whose axes are controllers of one axis each on one wire (two DMX on a bus): the acts of each.
// They begin a move together, one command on the wire apart, and each moves at its own pace.
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/pieces.h"
#include "core/sequence/sequence.h"

namespace hw {

/// A catalog with the axes of all members, named by their ids, and the inputs and outputs of the first. None:
/// a member has more than one axis, or no id.
[[nodiscard]] std::optional<Catalog> catalog_together(std::span<const Catalog* const> members);

/// The acts of the controller of each axis, in the order of the sequence's axes; all have equally many. `bus`
/// is from catalog_together(). Begins at the last place before `from_step` where the tool was up. The fault
/// names the step.
[[nodiscard]] Result<std::vector<Pieces>> pieces_together(const sequence::Sequence& sequence,
                                                          const Catalog& bus, int from_step);

/// The least duration of each piece: motions with their ramps, and delays, without the time on the wire.
/// Empty: some motions go at the controllers' own speed. Ramps that no step gives are assumed as from the
/// factory.
[[nodiscard]] std::vector<double> least_seconds(const std::vector<Pieces>& parts, const Catalog& bus);

}  // namespace hw
