#pragma once
// The absolute targets of a program text, for PlacesInText.
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// Of program `start` and those that it starts with SR, each in the order of the text, whatever jumps it
/// makes; a variable counts as what the text has set it to last, else as 0. A program that another starts
/// begins with what that one has homed. Targets of arcs are not among them.
[[nodiscard]] std::vector<AxisTarget> places_of_program(std::string_view text, int start,
                                                        const language::Dialect& dialect);

}  // namespace hw::arcus
