#pragma once
// Before a program in the controller is overwritten: whether it may be. At the foot of whatever runs one.
// Ids: `program/ask/overwrite`, `program/ask/fetch`, `program/ask/leave`.
#include "gui/shell/frame.h"

namespace hw::panels {

/// Pixels, over the width of the panel; 0: nothing is asked.
[[nodiscard]] float overwrite_question_height(const gui::Frame& frame);
void draw_overwrite_question(gui::Frame& frame, float top, float height);

}  // namespace hw::panels
