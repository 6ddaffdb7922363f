#pragma once
// Foreign text in sentences and on terminals: names of files, words of a command line, lines of a program.
#include <cstddef>
#include <string>
#include <string_view>

namespace hw {

/// Length of the UTF-8 character at `at`; 0: it is none.
std::size_t utf8_length(std::string_view text, std::size_t at);

enum class LineEnds : bool { written_out, kept };

/// What would act on a terminal or on the order of a line is written out: "\x1B", "\u202E". Longer than
/// `most` bytes, it is cut, and the rest counted.
std::string shown_text(std::string_view text, std::size_t most, LineEnds ends = LineEnds::written_out);

/// A path in a sentence.
inline std::string shown_path(std::string_view path) { return shown_text(path, 500); }

}  // namespace hw
