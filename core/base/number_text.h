#pragma once
// Numbers as protocols write them: ASCII digits, independent of the locale.
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace hw {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The whole text as a number; none if it contains anything else or does not fit.
template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number n{};
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, n);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return n;
}

/// The same for a number with decimals, which must be finite.
inline std::optional<double> finite_number(std::string_view text) {
  const auto n = whole_number<double>(text);
  return n && std::isfinite(*n) ? n : std::nullopt;
}

}  // namespace hw
