#pragma once
// The absolute targets of a program text, for PlacesInText.
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// Of all its programs, in the order of the text, whatever jumps it makes; a variable counts as what the text
/// has set it to last, else as 0. A GOSUB may home all axes that any subroutine homes. Those of arcs are not
/// among them.
[[nodiscard]] std::vector<AxisTarget> places_of_program(std::string_view text,
                                                        const language::Dialect& dialect);

}  // namespace hw::arcus
