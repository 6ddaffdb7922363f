#pragma once
// A hold-to-move button of any controller: `jog/AXIS/+`.
#include "gui/model/tab.h"
#include "gui/widgets/hold_button.h"

namespace hw::panels {

/// Draws at ImGui's cursor. Acts on `tab`, in front or not. Sets `options.disabled` and `.lit`.
void draw_jog_button(gui::Ui& ui, gui::Tab& tab, AxisId axis, Sign sign, std::string_view label,
                     gui::HoldOptions options);

}  // namespace hw::panels
