#pragma once
// Texts cut at a character.
#include <string_view>
#include <vector>

namespace hw {

/// The parts between the characters `at`; empty ones are kept, so there is at least one.
inline std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace hw
