#pragma once
#include "gui/shell/frame.h"

namespace hw::panels {

/// Draws the keys and the rules of manual operation in a column of this logical width. Ids: `help/1`,
/// `help/2` ...
void draw_keyboard_map(gui::PageFrame& frame, float width);

}  // namespace hw::panels
