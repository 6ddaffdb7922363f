#pragma once
// Draws the travel of an axis as a bar: the ends set for it, zero, target and position. Id: `dro/X/travel`.
#include <imgui.h>

#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Draws one line of small type, `width_px` wide; nothing if no end is set.
void draw_travel_bar(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px);
/// Draws the same without numbers, on the rule that ends the row of an axis, where a bar does not fit. `at`
/// is the left end of the rule.
void draw_travel_line(gui::Ui& ui, const gui::Tab& tab, AxisId axis, ImVec2 at, float width_px);
/// "0.000 to 300.000 mm", "up to 300.000 mm", "none".
gui::NumberText travel_words(const gui::Tab& tab, AxisId axis);
/// Why the set limits have no effect now; empty: they have, or none is set.
std::string_view why_travel_does_not_hold(const gui::Tab& tab, AxisId axis);

}  // namespace hw::panels
