#pragma once
// Draws bars that show how the time of a question is spent, all on the same scale.
#include <string_view>

#include "core/link/doctor.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// Draws a bar 28 high, with the name at the left and the total time at the right. `scale`: time of the full
/// width.
void draw_link_bar(gui::Ui& ui, std::string_view id, std::string_view name, ImVec2 at, float width,
                   const LinkBudget& budget, Duration scale);
/// Draws the meaning of the colours that occur.
void draw_link_legend(gui::Ui& ui, ImVec2 at, float width, const LinkBudget& budget);

}  // namespace hw::panels
