#pragma once
// Finds the places of undrawn entities in the model, because users look for them in the drawing, not in the
// file.
#include <string_view>
#include <vector>

#include "core/drawing/drawing.h"

namespace hw::drawing {

/// `text`: the file to which the lines in `left_out` refer. Entities in blocks get no place.
void find_places(std::string_view text, std::vector<LeftOut>& left_out);

}  // namespace hw::drawing
