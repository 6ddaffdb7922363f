#pragma once
#include "gui/shell/frame.h"

namespace hw::panels {

/// What each key does, and the rules of the hand: `help/1`, `help/2` ... in a column of that logical width.
void draw_keyboard_map(gui::PageFrame& frame, float width);

}  // namespace hw::panels
