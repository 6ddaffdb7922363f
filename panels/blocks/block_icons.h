#pragma once
// A shape for each kind of block, drawn, in its row and in the palette.
#include <imgui.h>

#include "core/sequence/sequence.h"

namespace hw::panels {

/// `size` in pixels is the side of the square it fits into, as draw_icon() has it.
void draw_block_icon(ImDrawList* list, const sequence::Step::Body& body, ImVec2 centre, float size,
                     ImU32 colour);

}  // namespace hw::panels
