#pragma once
// Hairlines that part a panel, and the row of buttons at its top.
#include <imgui.h>

#include "gui/shell/frame.h"

namespace hw::panels {

/// Over the whole width of the panel.
void draw_line_across(const gui::Frame& frame, float y_px);
/// From ImGui's cursor down to the panel's lower edge; the cursor goes behind it.
void draw_line_down(const gui::Frame& frame);
/// The cursor comes where the first button of the row goes; returns the corner of the row.
ImVec2 begin_toolbar(const gui::Frame& frame);
/// What comes next is `width` wide and stands `gap` behind the last button, or below the first where there is
/// no room.
void next_in_toolbar(const gui::Frame& frame, float gap, float width);
/// A line under it; the cursor comes below.
void end_toolbar(const gui::Frame& frame, ImVec2 corner);

}  // namespace hw::panels
