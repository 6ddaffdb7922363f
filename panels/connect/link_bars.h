#pragma once
// Bars that show how the time of one question is spent, on one scale.
#include <string_view>

#include "core/link/doctor.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// 28 high; name at the left, total time at the right. `scale`: the time of the full width.
void draw_link_bar(gui::Ui& ui, std::string_view id, std::string_view name, ImVec2 at, float width,
                   const LinkBudget& budget, Duration scale);
/// The meaning of the colours that occur.
void draw_link_legend(gui::Ui& ui, ImVec2 at, float width, const LinkBudget& budget);

}  // namespace hw::panels
