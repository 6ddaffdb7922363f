#pragma once
// Texts cut at a character.
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"

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

/// `count` whole numbers between such characters; none if the text is anything else.
inline std::optional<std::vector<std::int64_t>> whole_numbers(std::string_view text, char at,
                                                              std::size_t count) {
  std::vector<std::int64_t> all;
  for (const std::string_view part : split(text, at)) {
    const auto value = whole_number<std::int64_t>(part);
    if (!value) return std::nullopt;
    all.push_back(*value);
  }
  return all.size() == count ? std::optional(std::move(all)) : std::nullopt;
}

}  // namespace hw
