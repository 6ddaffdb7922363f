#pragma once
// A sequence as text for people to read and write: TOML, one line per step.
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Deepest nesting of loops, the outermost included.
inline constexpr int deepest_loop = 8;

/// The fault names the line and the unknown text in it. Anything unknown is a fault: nothing is left out
/// silently.
Result<Sequence> read_sequence(std::string_view text, const std::string& name);
/// The text reads back as an equal sequence.
std::string write_sequence(const Sequence& sequence);
/// Whether a text is meant as a sequence, valid or not.
bool looks_like_sequence(std::string_view text);

}  // namespace hw::sequence
