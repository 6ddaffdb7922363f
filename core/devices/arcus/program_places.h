#pragma once
// The absolute targets of a program text, for PlacesInText.
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// The places of program `start` and of those that it starts with SR, each in the order of the text, jumps
/// ignored. A variable has the value that the text has set last, else 0. A started program begins with the
/// axes that its starter has homed. Targets of arcs are not included.
[[nodiscard]] std::vector<AxisTarget> places_of_program(std::string_view text, int start,
                                                        const language::Dialect& dialect);

}  // namespace hw::arcus
