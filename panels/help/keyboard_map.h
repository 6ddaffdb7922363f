#pragma once
#include "gui/shell/frame.h"

namespace hw::panels {

/// The keys and the rules of manual operation, `help/1`, `help/2` ..., in a column of this logical width.
void draw_keyboard_map(gui::PageFrame& frame, float width);

}  // namespace hw::panels
