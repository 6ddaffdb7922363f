#pragma once
// Checks readable low-level lines for the problems that a text of the same meaning would have.
#include <vector>

#include "core/device/language.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

/// `problems`: those already reported; new ones are added. `source_line`: for each low-level line the line of
/// the text.
void check_listing(const Program& program, const std::vector<int>& source_line, const Dialect& dialect,
                   std::vector<Problem>& problems);

}  // namespace hw::arcus::language
