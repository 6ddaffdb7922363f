#pragma once
// Finds the places in the model of entities that are not drawn, as users look for them in the drawing, not in
// the file.
#include <string_view>
#include <vector>

#include "core/drawing/drawing.h"

namespace hw::drawing {

/// `text`: the file whose lines they give. Entities in blocks get no place.
void find_places(std::string_view text, std::vector<LeftOut>& left_out);

}  // namespace hw::drawing
