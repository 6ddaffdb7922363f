#pragma once
// Draws the text beside the number of an axis in the strip of a narrow window.
#include <imgui.h>

#include "gui/input/registry.h"
#include "gui/shell/frame.h"

namespace hw::panels {

inline constexpr float strip_limits_width = 36;
/// Draws the axis's limit lamps, because a narrow window has no limits panel.
void draw_strip_limits(gui::Frame& frame, AxisId axis, ImVec2 at);
/// For one of many axes: draws name and power, and in two small lines its state and activity.
void draw_beside_strip_number(gui::Frame& frame, AxisId axis, const gui::Rect& place);

}  // namespace hw::panels
