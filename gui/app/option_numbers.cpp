#include "gui/app/option_numbers.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace hw::app {

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    parts.emplace_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

tl::unexpected<Fault> wrong(const char* option, const Given& given, const char* form) {
  return fail(FaultKind::text, fmt::format("--{} {} is not understood.", option, given.one(option)), {},
              fmt::format("Write --{} {}.", option, form));
}

Result<std::vector<double>> numbers(const Given& given, const char* option, char at, std::size_t least,
                                    std::size_t most, const char* form) {
  std::vector<double> all;
  for (const std::string& part : split(given.one(option), at)) {
    const auto number = number_in(part);
    if (!number) return wrong(option, given, form);
    all.push_back(*number);
  }
  if (all.size() < least || all.size() > most) return wrong(option, given, form);
  return all;
}

}  // namespace hw::app
