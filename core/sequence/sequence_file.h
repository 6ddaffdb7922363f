#pragma once
// A sequence as a text that a person can read and write: TOML, one line for each step.
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Loops in loops, the outermost included.
inline constexpr int deepest_loop = 8;

/// The fault names the line and what it does not understand there. Anything that it does not know is a fault:
/// nothing is left out silently.
Result<Sequence> read_sequence(std::string_view text, const std::string& name);
/// Reads back as the same.
std::string write_sequence(const Sequence& sequence);
/// Whether a text is meant as one, right or wrong.
bool looks_like_sequence(std::string_view text);

}  // namespace hw::sequence
