#pragma once
// A typed number, and why it is not accepted.
#include <optional>
#include <string>
#include <string_view>

namespace hw::gui {

struct NumberRange {
  double min = -1e12, max = 1e12;
  int decimals = 0;  ///< shown; also the most that may be typed
  std::string_view unit = {};
};

/// "12,5" and "12.5" and "−12.5" and "57 000"; nothing when it is not one number.
std::optional<double> read_number(std::string_view text);
/// Why `text` is not accepted, in a few words: "1 to 6000 only"; empty when it is.
std::string range_sentence(std::string_view text, const NumberRange& range);

}  // namespace hw::gui
