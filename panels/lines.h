#pragma once
// Draws the dividing lines of a panel and the row of buttons at its top.
#include <imgui.h>

#include "gui/shell/frame.h"

namespace hw::panels {

/// Draws a line over the full width of the panel.
void draw_line_across(const gui::Frame& frame, float y_px);
/// Draws a line from ImGui's cursor to the panel's lower edge. The cursor moves to the right of the line.
void draw_line_down(const gui::Frame& frame);
/// Moves the cursor to the first button of the row. Returns the top left corner of the row.
ImVec2 begin_toolbar(const gui::Frame& frame);
/// Moves the cursor to the place of the next item, `width` wide: `gap` after the last button, or on a new
/// line if it does not fit.
void next_in_toolbar(const gui::Frame& frame, float gap, float width);
/// Draws a line below the row. The cursor moves below the line.
void end_toolbar(const gui::Frame& frame, ImVec2 corner);

}  // namespace hw::panels
