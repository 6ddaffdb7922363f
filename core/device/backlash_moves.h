#pragma once
// A move of the console that takes up the play of its axes.
#include <optional>

#include "core/device/intent.h"
#include "core/device/snapshot.h"

namespace hw {

/// The same move in two, the second of which ends the way that the user has chosen: as pieces, so that a stop
/// drops the second. None: it is no move, or ends that way by itself.
std::optional<intent::RunInPieces> with_backlash_taken_up(const Snapshot& now, const IntentBody& body);

/// Why the user's wish cannot be; empty: it can.
std::string say_no_backlash(const intent::SetBacklash& wish, std::size_t axes);

}  // namespace hw
