#pragma once
// The path of a contour, with equal scales on both axes.
#include "core/sequence/contour_path.h"
#include "gui/frame.h"
#include "gui/ui.h"

namespace hw::panels {

/// At ImGui's cursor, logical size. Strong while an output is on, thin else; dots: the lead-in. The ring
/// shows where the two axes are. `path`: in their steps, or null. Id: `contour/view`; `words` is its value
/// for scripts.
void draw_contour_preview(gui::Frame& frame, AxisId right, AxisId up, const sequence::ContourPath* path,
                          std::string_view words, float width, float height);

}  // namespace hw::panels
