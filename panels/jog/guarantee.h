#pragma once
// Says which part ends a held jog if this program dies, and how far the axis travels until then at the chosen
// speed.
#include "gui/input/registry.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Draws a line; `place` is at least 16 high. A narrow place gets fewer words. Returns true when it was
/// pressed and the controller can do more: see GuardOffer.
bool draw_guarantee(const gui::Frame& frame, const gui::Rect& place);

}  // namespace hw::panels
