#pragma once
// Dividing lines of a panel, and the row of buttons at its top.
#include <imgui.h>

#include "gui/shell/frame.h"

namespace hw::panels {

/// Over the full width of the panel.
void draw_line_across(const gui::Frame& frame, float y_px);
/// Draws from ImGui's cursor to the panel's lower edge; the cursor moves to the right of the line.
void draw_line_down(const gui::Frame& frame);
/// Puts the cursor at the first button of the row; returns the corner of the row.
ImVec2 begin_toolbar(const gui::Frame& frame);
/// Places the next item, `width` wide, `gap` after the last button, or below the first if there is no room.
void next_in_toolbar(const gui::Frame& frame, float gap, float width);
/// Draws a line under the row; the cursor moves below.
void end_toolbar(const gui::Frame& frame, ImVec2 corner);

}  // namespace hw::panels
