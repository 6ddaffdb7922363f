#pragma once
// Which state word an axis and a whole controller deserve. One place, so that digits, tabs and lamps agree.
#include "core/device/snapshot.h"
#include "gui/widgets/state_word.h"

namespace hw::gui {

/// What is not known comes first: an axis that cannot be seen is not called idle.
State state_of(const Snapshot& now, int axis, Instant clock);
/// The worst state of all axes and the link; `moving` when several move.
State worst_state(const Snapshot& now, Instant clock);
bool is_motion(State state);
/// From harmless to bad.
int badness(State state);
/// The position is older than three poll periods.
bool is_old(const Snapshot& now, int axis, Instant clock);

}  // namespace hw::gui
