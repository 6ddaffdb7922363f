#pragma once
// How long a rehearsed program was at each part of its text.
#include <span>
#include <vector>

#include "core/device/language.h"

namespace hw {

/// By part, in seconds. `part_of_command`: by RehearsedTurn::command; a command of no part (-1) belongs to
/// the part before it. Parts that never ran are missing.
std::vector<double> seconds_of_parts(const Rehearsal& rehearsal, std::span<const int> part_of_command);

}  // namespace hw
