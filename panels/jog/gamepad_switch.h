#pragma once
// `jog/gamepad`: arms the gamepad, where one is plugged in. It has a place beside the buttons that nothing
// else takes, so that plugging one in moves none of them.
#include <imgui.h>

#include "gui/shell/frame.h"
#include "panels/widget_path.h"

namespace hw::panels {

/// At `at`, a square of `side`, logical. Draws nothing where there is no gamepad.
void draw_gamepad_switch(gui::Frame& frame, ImVec2 at, float side);
/// How it jogs, while it is armed.
Path gamepad_hint(const gui::Frame& frame);

}  // namespace hw::panels
