#pragma once
// Reads values from the controller for a rehearsal: the set-up before it, and the programs and variables that
// it has reached after it. For the program editor and the blocks. GUI thread.
#include "core/device/catalog.h"
#include "gui/model/rehearsals.h"
#include "gui/model/unread_programs.h"

namespace hw::gui {

/// Once a frame, while set-up values are missing: asks for them once. Returns whether they are still awaited.
/// `asked`: 0 before the first call.
[[nodiscard]] bool awaits_set_up(IntentId& asked, const Snapshot& now, const UnreadPrograms::Send& send);

/// Returns whether this rehearsal has reached a program or a variable that is to be read now, so that it has
/// to be repeated. Nothing is read while something runs or moves: the rehearsal states what it assumed.
[[nodiscard]] bool reached_unread(UnreadPrograms& unread, const Rehearsals::Outcome& outcome,
                                  const Snapshot& now, const Catalog& catalog);

}  // namespace hw::gui
