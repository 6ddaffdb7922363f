#pragma once
// `jog/gamepad`: arms the gamepad, if one is plugged in. Its place beside the buttons is reserved, so that
// plugging in a gamepad moves none of them.
#include <imgui.h>

#include "gui/shell/frame.h"
#include "panels/widget_path.h"

namespace hw::panels {

/// Draws a square of `side` (logical) at `at`. Draws nothing without a gamepad.
void draw_gamepad_switch(gui::Frame& frame, ImVec2 at, float side);
/// Says how the armed gamepad jogs.
Path gamepad_hint(const gui::Frame& frame);

}  // namespace hw::panels
