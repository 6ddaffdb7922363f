#pragma once
// What a step is called and says, for people.
#include <string>
#include <string_view>

#include "core/base/fixed_text.h"
#include "core/sequence/sequence.h"

namespace hw::sequence {

/// "Move to", "Circle".
std::string_view title_of(const Step::Body& body);
/// "X 40, Y 25", "until input 2 is on".
std::string summary_of(const Step::Body& body, const Sequence& of);
/// A field of a step, from its key in files: "ramp_ms" is "Ramp, ms".
FixedText<64> label_of_field(std::string_view key, const Sequence& of);

}  // namespace hw::sequence
