#include "gui/model/units_format.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/core.h>

namespace hw::gui {
namespace {

constexpr std::string_view minus_sign = "\u2212", thin_space = "\u2009";

bool stands_close(std::string_view unit) { return unit == "°" || unit.empty(); }

std::string_view trim(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

void replace_all(std::string& s, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = s.find(from, at)) != std::string::npos; at += to.size())
    s.replace(at, from.size(), to);
}

}  // namespace

void NumberText::append(std::string_view s) {
  const std::size_t n = std::min(s.size(), sizeof(bytes_) - size_);
  std::memcpy(bytes_ + size_, s.data(), n);
  size_ += n;
}

NumberText format_number(double value, int decimals) {
  char plain[48];
  const auto end = fmt::format_to_n(plain, sizeof(plain), "{:.{}f}", std::fabs(value), decimals);
  const std::string_view digits(plain, std::min(end.size, sizeof(plain)));
  const std::size_t whole = std::min(digits.find('.'), digits.size());
  const bool all_zero = digits.find_first_not_of("0.") == std::string_view::npos;
  NumberText out;
  if (value < 0 && !all_zero) out.append(minus_sign);
  for (std::size_t i = 0; i < whole; ++i) {
    if (i > 0 && whole >= 5 && (whole - i) % 3 == 0) out.append(thin_space);
    out.append(digits.substr(i, 1));
  }
  out.append(digits.substr(whole));
  return out;
}

double from_steps(Steps steps, const DisplayUnit& unit) {
  return unit.real ? static_cast<double>(steps.value) * unit.per_step : static_cast<double>(steps.value);
}

Steps to_steps(double value, const DisplayUnit& unit) {
  return Steps(std::llround(unit.real ? value / unit.per_step : value));
}

NumberText format_position(Steps position, const DisplayUnit& unit) {
  return format_number(from_steps(position, unit), unit.real ? unit.decimals : 0);
}

NumberText format_with_unit(Steps position, const DisplayUnit& unit) {
  NumberText out = format_position(position, unit);
  if (!stands_close(unit.name)) out.append(" ");
  std::string_view name = unit.name;
  if (!unit.real && std::llabs(position.value) == 1 && name.ends_with('s')) name.remove_suffix(1);
  out.append(name);
  return out;
}

NumberText format_speed(Pps speed, const DisplayUnit& unit) {
  const double value = unit.real ? speed.value * unit.per_step : speed.value;
  NumberText out = format_number(value, unit.real ? unit.decimals : 0);
  if (!stands_close(unit.name)) out.append(" ");
  out.append(unit.name);
  out.append("/s");
  return out;
}

std::string counted_unit(const Catalog& catalog, const Snapshot& now, std::string_view unit, int axis) {
  std::string text(unit);
  const std::size_t word = text.find(catalog.step_word);
  if (catalog.loop_word.empty() || word == text.npos) return text;
  int asked = 0, closed = 0;
  for (int i = 0; i < now.axis_count; ++i) {
    if (axis >= 0 && i != axis) continue;
    ++asked;
    closed += now.axes[static_cast<std::size_t>(i)].in_counts;
  }
  if (closed > 0)
    text.replace(word, catalog.step_word.size(), closed == asked ? catalog.loop_word : std::string());
  return text;
}

std::string count_of(int n, std::string_view unit) {
  if (n == 1 && unit.ends_with('s')) unit.remove_suffix(1);
  return fmt::format("{} {}", n, unit);
}

NumberText format_duration(double s) {
  const auto whole = static_cast<long long>(s);
  NumberText out;
  const auto two = [&](long long first, std::string_view first_word, long long second,
                       std::string_view second_word) {
    out.append(format_number(static_cast<double>(first), 0));
    out.append(first_word);
    if (second < 10) out.append("0");
    out.append(format_number(static_cast<double>(second), 0));
    out.append(second_word);
  };
  if (s >= 3600) {
    two(whole / 3600, " h ", whole / 60 % 60, " min");
  } else if (s >= 60) {
    two(whole / 60, " min ", whole % 60, " s");
  } else {
    out.append(s < 10 ? format_number(s, 1) : format_number(static_cast<double>(whole), 0));
    out.append(" s");
  }
  return out;
}

Result<double> parse_number(std::string_view typed) {
  std::string s(trim(typed));
  replace_all(s, minus_sign, "-");
  replace_all(s, thin_space, "");
  replace_all(s, "\u00a0", "");
  replace_all(s, " ", "");
  const auto marks = std::count_if(s.begin(), s.end(), [](char c) { return c == '.' || c == ','; });
  if (marks > 1)
    return fail(FaultKind::text, fmt::format("\"{}\" has more than one decimal mark.", trim(typed)),
                "Nothing was sent.", "Type it with one point or one comma.");
  std::replace(s.begin(), s.end(), ',', '.');
  const char* begin = s.data();
  if (!s.empty() && *begin == '+') ++begin;
  double value = 0;
  const auto read = std::from_chars(begin, s.data() + s.size(), value, std::chars_format::fixed);
  if (s.empty() || read.ec != std::errc() || read.ptr != s.data() + s.size() || !std::isfinite(value) ||
      (begin != s.data() && *begin == '-'))
    return fail(FaultKind::text, fmt::format("\"{}\" is not a number.", trim(typed)), "Nothing was sent.");
  return value;
}

Result<Steps> parse_position(std::string_view text, const DisplayUnit& unit) {
  std::string_view number = trim(text);
  if (number.ends_with(unit.name))
    number.remove_suffix(unit.name.size());
  else if (!unit.real && unit.name.ends_with('s') &&
           number.ends_with(unit.name.substr(0, unit.name.size() - 1)))
    number.remove_suffix(unit.name.size() - 1);  // "1 step"
  const auto value = parse_number(number);
  if (!value) return fail(value.error());
  if (!unit.real && *value != std::floor(*value))
    return fail(FaultKind::text, fmt::format("{} is not a whole number of {}.", trim(text), unit.name),
                "Nothing was sent.");
  if (std::fabs(unit.real ? *value / unit.per_step : *value) > 9e15)
    return fail(FaultKind::text, fmt::format("{} is too far for any controller.", trim(text)),
                "Nothing was sent.");
  return to_steps(*value, unit);
}

std::vector<JogStep> jog_steps(const DisplayUnit& unit, int many) {
  std::vector<JogStep> list;
  if (!unit.real) {
    for (std::int64_t n = 1; static_cast<int>(list.size()) < many; n *= 10) {
      const std::string label(format_with_unit(Steps(n), unit).view());
      list.push_back(
          {Steps(n), std::to_string(n), label, {}, std::string(format_position(Steps(n), unit).view())});
    }
    return list;
  }
  list.push_back(
      {Steps(1), "step", "1 step", std::string(format_with_unit(Steps(1), unit).view()), "1 step"});
  // The first power of ten well above one step, so that no two entries are alike.
  int exponent = static_cast<int>(std::ceil(std::log10(1.5 * std::fabs(unit.per_step))));
  for (; static_cast<int>(list.size()) < many; ++exponent) {
    const double length = std::pow(10.0, exponent);
    const Steps steps(std::llabs(to_steps(length, unit).value));
    const std::string number = fmt::format("{:.{}f}", length, std::max(0, -exponent));
    JogStep step{steps, number, number + (stands_close(unit.name) ? "" : " ") + unit.name, {}, number};
    const double reached = std::fabs(from_steps(steps, unit));
    if (std::fabs(reached - length) > 1e-9 * length)
      step.caption = fmt::format("{} steps: {}", steps.value, format_number(reached, unit.decimals).view());
    list.push_back(std::move(step));
  }
  return list;
}

int decimals_of(double per_step) {
  if (per_step == 0) return 0;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(std::abs(per_step)) - 1e-9)), 0, 6);
}

}  // namespace hw::gui
