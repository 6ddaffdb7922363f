#pragma once
// Draws the icon of each kind of block, for its row and for the palette.
#include <imgui.h>

#include "core/sequence/sequence.h"

namespace hw::panels {

/// `size`: side of the enclosing square in pixels, as for draw_icon().
void draw_block_icon(ImDrawList* list, const sequence::Step::Body& body, ImVec2 centre, float size,
                     ImU32 colour);

}  // namespace hw::panels
