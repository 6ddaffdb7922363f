#pragma once
// What stands beside the number of an axis in the strip of a narrow window.
#include <imgui.h>

#include "gui/input/registry.h"
#include "gui/shell/frame.h"

namespace hw::panels {

inline constexpr float strip_limits_width = 36;
/// Its limit lamps, since there is no panel of limits.
void draw_strip_limits(gui::Frame& frame, AxisId axis, ImVec2 at);
/// One of many: its name and power, and in two small lines its state and what it does.
void draw_beside_strip_number(gui::Frame& frame, AxisId axis, const gui::Rect& place);

}  // namespace hw::panels
