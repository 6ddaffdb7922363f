#pragma once
// Foreign text in sentences and on terminals: names of files, words of a command line, lines of a program.
#include <cstddef>
#include <string>
#include <string_view>

namespace hw {

/// Length in bytes of the UTF-8 character at `at`; 0: no valid character.
std::size_t utf8_length(std::string_view text, std::size_t at);

enum class LineEnds : bool { written_out, kept };

/// Writes out characters that would act on a terminal or on the order of a line: "\x1B", "\u202E". A text
/// longer than `most` bytes is cut, and the rest counted.
std::string shown_text(std::string_view text, std::size_t most, LineEnds ends = LineEnds::written_out);

/// A path in a sentence.
inline std::string shown_path(std::string_view path) { return shown_text(path, 500); }

}  // namespace hw
