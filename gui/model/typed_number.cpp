#include "gui/model/typed_number.h"

#include <charconv>
#include <cmath>

#include "gui/model/units_format.h"

namespace hw::gui {
namespace {

/// A number in short form: "0.5", not "0.500".
std::string short_number(double value, int decimals) {
  std::string s(format_number(value, decimals).view());
  if (s.find('.') == std::string::npos) return s;
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s;
}

int decimals_typed(std::string_view text) {
  const std::size_t point = text.find_first_of(".,");
  if (point == std::string_view::npos) return 0;
  int n = 0;
  for (char c : text.substr(point + 1)) n += c >= '0' && c <= '9';
  return n;
}

}  // namespace

std::optional<double> read_number(std::string_view text) {
  char plain[64] = {};
  std::size_t n = 0;
  bool point = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    if (n + 1 >= sizeof plain) return {};
    if (rest.starts_with("\xE2\x88\x92")) {  // the real minus sign
      plain[n++] = '-';
      i += 3;
    } else if (rest.starts_with("\xE2\x80\x89")) {  // thin space between groups
      i += 3;
    } else if (rest[0] == ',' || rest[0] == '.') {
      if (point) return {};
      point = true;
      plain[n++] = '.';
      ++i;
    } else if (rest[0] == ' ' || (rest[0] == '+' && n == 0)) {
      ++i;
    } else {
      plain[n++] = rest[0];
      ++i;
    }
  }
  double value = 0;
  const auto [end, error] = std::from_chars(plain, plain + n, value, std::chars_format::fixed);
  if (n == 0 || error != std::errc() || end != plain + n || !std::isfinite(value)) return {};
  return value;
}

std::string range_sentence(std::string_view text, const NumberRange& range) {
  const std::optional<double> value = read_number(text);
  std::string unit;
  if (!range.unit.empty()) unit.append(" ").append(range.unit);
  if (!value) return text.empty() ? "Type a number." : "This is not a number.";
  if (*value < range.min || *value > range.max) {
    if (range.min <= -1e12) return "At most " + short_number(range.max, range.decimals) + unit + ".";
    if (range.max >= 1e12) return "At least " + short_number(range.min, range.decimals) + unit + ".";
    return short_number(range.min, range.decimals) + " to " + short_number(range.max, range.decimals) + unit +
           " only";
  }
  if (decimals_typed(text) > range.decimals) {
    const double scale = std::pow(10.0, range.decimals);
    if (std::fabs(*value * scale - std::round(*value * scale)) > 1e-6)
      return range.decimals == 0 ? "Whole numbers only"
                                 : "At most " + std::to_string(range.decimals) + " decimals";
  }
  return {};
}

}  // namespace hw::gui
