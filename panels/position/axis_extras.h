#pragma once
// What an axis has to tell beside its position: motor power with its switch, what it does on its ramp, how
// fast, and its encoder. Under the number of a few axes, left of the numbers of many. Ids: `dro/X/power`,
// `dro/X/phase`, `dro/X/speed`, `dro/X/encoder`.
#include <string_view>

#include <imgui.h>

#include "gui/input/registry.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Logical; 0: nothing to tell.
float axis_extras_height(const Catalog& catalog, AxisId axis);
/// All of it in one line.
void draw_axis_extras(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px);

/// The switch of the motor's current, small: lamp and "power on", or "on" when `brief`. Returns its width in
/// pixels; 0: it cannot be switched.
float power_width(const gui::Frame& frame, AxisId axis, bool brief);
void draw_power(gui::Frame& frame, AxisId axis, ImVec2 at, float height, bool brief);
/// "encoder 8000", or the number alone in less room; nothing when it has none.
void draw_encoder(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px, bool right_aligned);
/// "accelerating" while it moves, else the error that holds it: "stalled".
std::string_view phase_of(const gui::Frame& frame, AxisId axis);
/// Registers phase and speed where they are drawn.
void show_phase(gui::Frame& frame, AxisId axis, const gui::Rect& where);

}  // namespace hw::panels
