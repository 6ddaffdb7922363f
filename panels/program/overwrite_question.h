#pragma once
// Asks before a program in the controller is overwritten, at the foot of any panel that runs one. Ids:
// `program/ask/overwrite`, `program/ask/fetch`, `program/ask/leave`.
#include "gui/shell/frame.h"

namespace hw::panels {

/// Height of the question over the width of the panel, in pixels; 0: no question.
[[nodiscard]] float overwrite_question_height(const gui::Frame& frame);
void draw_overwrite_question(gui::Frame& frame, float top, float height);

}  // namespace hw::panels
