#pragma once
// Programs that were written from a sequence are bound by the user's travel and by what is not known of the
// axes, wherever they are run from; a text of the user's own is his own word. GUI thread.
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/sequence/sequence.h"

namespace hw::gui {

class Desk;
class Tab;

/// Where the program takes the axes that the controller holds there, for intent::RunProgram; empty: it is of
/// no sequence that is known here.
std::vector<AxisTarget> places_of_held(Desk& desk, int slot, const Catalog& catalog, const Snapshot& now);

/// Why it cannot be run from where the axes stand, in the units that are shown: it leaves the user's travel,
/// or is sent by a count that is not to be trusted. Empty: it can.
std::string why_not_run_there(const Tab& tab, const sequence::Sequence& sequence);
/// The same of a text; of one that is of no sequence nothing is said.
std::string why_not_run_there(Tab& tab, const std::string& text);

}  // namespace hw::gui
