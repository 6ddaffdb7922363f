#pragma once
// Draws the text made from the blocks, beside them, with the lines of the chosen block marked. Ids:
// `blocks/text`, `blocks/problem`, `blocks/show_refused`.
#include "gui/shell/frame.h"
#include "panels/blocks/block_choice.h"
#include "panels/blocks/block_work.h"

namespace hw::panels {

/// The lines to mark: those of the chosen blocks and those of the block that is executed.
struct BlockTextMarks {
  const BlockChoice& chosen;
  int live_step = -1;
};
/// Draws from ImGui's cursor to the right edge. Logical height. Returns true when the user asks for the first
/// refused block. The title shows how much memory the blocks take.
bool draw_block_text(gui::Frame& frame, const WrittenBlocks& written, const BlockTextMarks& marks,
                     float height);
/// Draws how many blocks are refused, or why none can be written. Returns true as above.
bool draw_block_problem(gui::Frame& frame, const WrittenBlocks& written, float width);

}  // namespace hw::panels
