#pragma once
// The text that blocks become, beside them, with the lines of the chosen block marked. Ids: `blocks/text`,
// `blocks/problem`.
#include "gui/shell/frame.h"
#include "panels/blocks/block_work.h"

namespace hw::panels {

/// At ImGui's cursor, to the right edge, logical height.
void draw_block_text(gui::Frame& frame, const WrittenBlocks& written, int chosen_row, float height);
/// Why they cannot be written.
void draw_block_problem(gui::Frame& frame, const WrittenBlocks& written, float width);

}  // namespace hw::panels
