#pragma once
// One hold-to-move button of any controller: `jog/AXIS/+`.
#include "gui/model/tab.h"
#include "gui/widgets/hold_button.h"

namespace hw::panels {

/// At ImGui's cursor. Acts on `tab`, whether it is the one in front or not. `options.disabled` and `.lit` are
/// set here.
void draw_jog_button(gui::Ui& ui, gui::Tab& tab, AxisId axis, Sign sign, std::string_view label,
                     gui::HoldOptions options);

}  // namespace hw::panels
