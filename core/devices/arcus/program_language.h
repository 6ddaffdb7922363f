#pragma once
// Program texts of the Arcus controllers while they are typed: colours, costs, problems in sentences.
#include "core/device/language.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// One text holds all programs of a controller: everything is in slot 0. A text with errors has no listing.
[[nodiscard]] ProgramReport analyse_program(std::string_view text, const language::Dialect& dialect);

}  // namespace hw::arcus
