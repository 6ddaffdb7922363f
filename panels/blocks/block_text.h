#pragma once
// The text that blocks become, beside them, with the lines of the chosen block marked. Ids: `blocks/text`,
// `blocks/problem`, `blocks/show_refused`.
#include "gui/shell/frame.h"
#include "panels/blocks/block_choice.h"
#include "panels/blocks/block_work.h"

namespace hw::panels {

/// Which lines are marked: those of the chosen blocks, and of the one that the controller is at.
struct BlockTextMarks {
  const BlockChoice& chosen;
  int live_step = -1;
};
/// At ImGui's cursor, to the right edge, logical height. True: the first block that is refused is wanted.
bool draw_block_text(gui::Frame& frame, const WrittenBlocks& written, const BlockTextMarks& marks,
                     float height);
/// How many of them are refused, or why none can be written. True as above.
bool draw_block_problem(gui::Frame& frame, const WrittenBlocks& written, float width);

}  // namespace hw::panels
