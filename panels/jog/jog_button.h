#pragma once
// Draws a hold-to-move button of any controller: `jog/AXIS/+`.
#include "gui/model/tab.h"
#include "gui/widgets/hold_button.h"
#include "panels/widget_path.h"

namespace hw::panels {

/// "A tap moves it 0.500 mm; held, it runs at 2.500 mm/s.", in the unit of this axis.
[[nodiscard]] Path tap_and_hold(const gui::Tab& tab, AxisId axis);

/// Draws at ImGui's cursor. Jogs `tab`, in front or not. Sets `options.disabled`, `.lit` and `.tip`.
void draw_jog_button(gui::Ui& ui, gui::Tab& tab, AxisId axis, Sign sign, std::string_view label,
                     gui::HoldOptions options);

}  // namespace hw::panels
