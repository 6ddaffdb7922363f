#pragma once
// The path of a contour, with equal scales on both axes.
#include "core/device/contour_plan.h"
#include "gui/frame.h"
#include "gui/ui.h"

namespace hw::panels {

/// At ImGui's cursor, logical size. Strong while an output is on, thin else; dots: the lead-in. The ring
/// shows where the axes are. Id: `contour/view`; `words` is its value for scripts.
void draw_contour_preview(gui::Frame& frame, const ContourPlan& plan, const ContourShape* shape,
                          std::string_view words, float width, float height);

}  // namespace hw::panels
