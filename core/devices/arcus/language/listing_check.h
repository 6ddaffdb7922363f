#pragma once
// What is wrong with low-level lines that can be read: the same that is wrong with a text of that meaning.
#include <vector>

#include "core/device/language.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

/// `problems`: what has been said of the lines already. `source_line`: for each low-level line the line of
/// the text.
void check_listing(const Program& program, const std::vector<int>& source_line, const Dialect& dialect,
                   std::vector<Problem>& problems);

}  // namespace hw::arcus::language
