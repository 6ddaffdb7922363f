#include "core/base/shown_text.h"

#include <algorithm>
#include <cstdint>

#include <fmt/core.h>

namespace hw {
namespace {

std::uint32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  const std::size_t n = character.size();
  std::uint32_t code = n == 1 ? first : first & (0x7Fu >> n);
  for (std::size_t i = 1; i < n; ++i) code = code << 6 | (static_cast<unsigned char>(character[i]) & 0x3F);
  return code;
}

/// Controls, line and paragraph separators, and characters that change the direction of writing.
bool acts(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

std::string shown_character(std::string_view character) {
  const std::uint32_t code = code_point(character);
  if (!acts(code)) return std::string(character);
  return code < 0x80 ? fmt::format("\\x{:02X}", code) : fmt::format("\\u{:04X}", code);
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(text[n]); };
  const unsigned char first = byte(at);
  const std::size_t n = first < 0x80                    ? 1
                        : first >= 0xC2 && first < 0xE0 ? 2
                        : first >= 0xE0 && first < 0xF0 ? 3
                        : first >= 0xF0 && first < 0xF5 ? 4
                                                        : 0;
  if (n == 0 || at + n > text.size()) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  return n;
}

std::string shown_text(std::string_view text, std::size_t most, LineEnds ends) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size() && at < most) {
    const bool end = text[at] == '\n' || text[at] == '\t';
    const std::size_t n = utf8_length(text, at);
    if (n == 0)
      out += fmt::format("\\x{:02X}", static_cast<unsigned char>(text[at]));
    else if (end && ends == LineEnds::kept)
      out += text[at];
    else
      out += shown_character(text.substr(at, n));
    at += std::max<std::size_t>(n, 1);
  }
  if (at < text.size()) out += fmt::format("... ({} bytes more)", text.size() - at);
  return out;
}

}  // namespace hw
