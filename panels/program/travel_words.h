#pragma once
// Warns of the user's limits that a rehearsed program would pass. The program may run all the same.
#include <string>
#include <vector>

#include "core/device/language.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Whether the program passes a limit.
[[nodiscard]] bool passes_travel(const gui::Frame& frame, const Rehearsal& rehearsal);
/// "Past the + limit of X, 300.000 mm, after 4.1 s, and up to 318.000 mm." for each end. `rehearsal`: from
/// the present position.
[[nodiscard]] std::vector<std::string> past_travel_words(const gui::Frame& frame, const Rehearsal& rehearsal);

}  // namespace hw::panels
