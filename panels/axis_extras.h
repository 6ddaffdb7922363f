#pragma once
// The line under the position of an axis that has more to tell: motor power with its switch, what it does on
// its ramp, and the encoder beside the position. Ids: `dro/X/power`, `dro/X/phase`, `dro/X/speed`,
// `dro/X/encoder`.
#include <imgui.h>

#include "gui/frame.h"

namespace hw::panels {

/// Logical; 0: nothing to tell.
float axis_extras_height(const Catalog& catalog, AxisId axis);
void draw_axis_extras(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px);

}  // namespace hw::panels
