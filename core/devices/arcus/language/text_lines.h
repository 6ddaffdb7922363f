#pragma once
// The lines of a text, whatever system wrote it.
#include <string_view>

namespace hw::arcus::language {

/// Calls f(line, number) for each line without its end; the last one may be empty.
template <class F>
void for_each_line(std::string_view text, F f) {
  int number = 0;
  for (;;) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    f(line, number++);
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

}  // namespace hw::arcus::language
