#pragma once
// Describes the result of a rehearsal in sentences for the user.
#include <string>
#include <vector>

#include "gui/model/rehearsals.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// A time to a tenth of a second, to compare two runs: "1 min 08.6 s".
[[nodiscard]] std::string exact_time(double seconds);
/// Why limits were not judged; empty: they were.
[[nodiscard]] std::string stand_words(const gui::Frame& frame, const gui::Rehearsals::Outcome& outcome);
/// "Line 3, 2.4 s: Axis X runs into its plus limit switch.", without the stop that Rehearsal::error names.
[[nodiscard]] std::vector<std::string> stop_words(const Rehearsal& rehearsal);
/// The memory that the text takes: "14 of 1,275 lines"; empty: the controller does not store it.
[[nodiscard]] std::string memory_words(const Rehearsal& rehearsal, const ProgramFacts& facts);
/// The assumptions made, in one sentence; empty: none.
[[nodiscard]] std::string assumption_words(const Rehearsal& rehearsal);

}  // namespace hw::panels
