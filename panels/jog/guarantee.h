#pragma once
// Who ends a held jog when this program dies, and how far it goes until then at the chosen speed.
#include "gui/input/registry.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// In one line, `place` being at least 16 high; in less room with fewer words. True: it was pressed, where
/// the controller can do more about it: see GuardOffer.
bool draw_guarantee(const gui::Frame& frame, const gui::Rect& place);

}  // namespace hw::panels
