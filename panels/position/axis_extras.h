#pragma once
// Shows the state of an axis beside its position: motor power with its switch, ramp phase, speed, and
// encoder. It is below the number of a few axes, left of the numbers of many. Ids: `dro/X/power`,
// `dro/X/phase`, `dro/X/speed`, `dro/X/encoder`.
#include <string_view>

#include <imgui.h>

#include "gui/input/registry.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// The height, logical; 0: there is no such state.
float axis_extras_height(const Catalog& catalog, AxisId axis);
/// Draws it in one line.
void draw_axis_extras(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px);

/// The small motor power switch: lamp and "power on", or "on" when `brief`. Returns its width in pixels; 0:
/// the power cannot be switched.
float power_width(const gui::Frame& frame, AxisId axis, bool brief);
void draw_power(gui::Frame& frame, AxisId axis, ImVec2 at, float height, bool brief);
/// Draws "encoder 8000", or only the number in a narrow place; nothing without an encoder.
void draw_encoder(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px, bool right_aligned);
/// "accelerating" during motion, else the error that stops the axis: "stalled".
std::string_view phase_of(const gui::Frame& frame, AxisId axis);
/// Registers phase and speed at their place.
void show_phase(gui::Frame& frame, AxisId axis, const gui::Rect& where);

}  // namespace hw::panels
