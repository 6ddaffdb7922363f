#pragma once
// How the lines of a text belong together: programs and their END, subroutines, blocks, calls (AMB-116).
#include <vector>

#include "core/devices/arcus/language/parser.h"

namespace hw::arcus::language {

void check_structure(const std::vector<Statement>& statements, std::vector<Problem>& problems);
/// Reports GOSUBs without a target, or nested deeper than the controller allows.
void check_calls(const std::vector<Statement>& statements, std::vector<Problem>& problems);

}  // namespace hw::arcus::language
