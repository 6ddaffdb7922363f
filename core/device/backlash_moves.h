#pragma once
// Moves of the console that take up backlash.
#include <optional>

#include "core/device/intent.h"
#include "core/device/snapshot.h"

namespace hw {

/// The move as two pieces, of which the second ends in the user's direction; a stop drops the second. None:
/// the intent is not a move, or the move ends in that direction anyway.
std::optional<intent::RunInPieces> with_backlash_taken_up(const Snapshot& now, const IntentBody& body);

/// Why these values are not possible, as a sentence; empty: they are possible.
std::string describe_no_backlash(const intent::SetBacklash& request, std::size_t axes);

}  // namespace hw
