#pragma once
// How long a rehearsed program was at each part of its text.
#include <span>
#include <vector>

#include "core/device/language.h"

namespace hw {

/// By part, in seconds: from the event of its first command to that of the next part. `part_of_command`: by
/// RehearsedEvent::command of program 0; a command of no part (-1) belongs to the part before it. Of parts
/// that the rehearsal has not listed there is nothing.
std::vector<double> seconds_of_parts(const Rehearsal& rehearsal, std::span<const int> part_of_command);

}  // namespace hw
