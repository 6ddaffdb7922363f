#pragma once
// How the lines of a text belong together: programs and their END, subroutines, blocks, calls (AMB-116).
#include <vector>

#include "core/devices/arcus/language/parser.h"

namespace hw::arcus::language {

void check_structure(const std::vector<Statement>& statements, std::vector<Problem>& problems);
/// GOSUBs that lead nowhere, or that nest deeper than the controller can.
void check_calls(const std::vector<Statement>& statements, std::vector<Problem>& problems);

}  // namespace hw::arcus::language
