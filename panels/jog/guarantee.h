#pragma once
// Tells who ends a held jog if this program dies, and how far the axis travels until then at the chosen
// speed.
#include "gui/input/registry.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Draws one line; `place` is at least 16 high. Less room takes fewer words. True: pressed, where the
/// controller can do more: see GuardOffer.
bool draw_guarantee(const gui::Frame& frame, const gui::Rect& place);

}  // namespace hw::panels
