#pragma once
// Bars that show where the time of one question goes, on one scale.
#include <string_view>

#include "core/link/doctor.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// 28 high; name at the left, the whole time at the right. `scale`: what the full width stands for.
void draw_link_bar(gui::Ui& ui, std::string_view id, std::string_view name, ImVec2 at, float width,
                   const LinkBudget& budget, Duration scale);
/// What the colours mean, of those that occur.
void draw_link_legend(gui::Ui& ui, ImVec2 at, float width, const LinkBudget& budget);

}  // namespace hw::panels
