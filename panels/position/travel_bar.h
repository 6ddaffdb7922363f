#pragma once
// How far an axis may go and where it is between: the ends that are set for it, zero, where it is sent and
// where it stands. Id `dro/X/travel`.
#include <imgui.h>

#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// In one line of small type, `width_px` wide; nothing where no end is set.
void draw_travel_bar(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px);
/// "0.000 to 300.000 mm", "up to 300.000 mm", "none".
gui::NumberText travel_words(const gui::Frame& frame, AxisId axis);
/// Why limits that are set do not hold now; empty: they do, or none is set.
std::string_view why_travel_does_not_hold(const gui::Frame& frame, AxisId axis);

}  // namespace hw::panels
