#pragma once
// What a rehearsal came to, in sentences for the user.
#include <string>
#include <vector>

#include "gui/model/rehearsals.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// To a tenth of a second, as a person compares two runs: "1 min 08.6 s".
[[nodiscard]] std::string exact_time(double seconds);
/// Why nothing is said of limits; empty: something is.
[[nodiscard]] std::string stand_words(const gui::Frame& frame, const gui::Rehearsals::Outcome& outcome);
/// "Line 3, 2.4 s: Axis X runs into its plus limit switch.", without what Rehearsal::error says already.
[[nodiscard]] std::vector<std::string> stop_words(const Rehearsal& rehearsal);
/// What was taken for granted, in one sentence; empty: nothing was.
[[nodiscard]] std::string assumption_words(const Rehearsal& rehearsal);

}  // namespace hw::panels
