#include "gui/app/option_numbers.h"

#include <fmt/format.h>

#include "core/base/number_text.h"
#include "core/base/split.h"

namespace hw::app {

tl::unexpected<Fault> wrong(const char* option, const Given& given, const char* form) {
  return fail(FaultKind::text, fmt::format("--{} {} is not understood.", option, given.one(option)), {},
              fmt::format("Write --{} {}.", option, form));
}

Result<std::vector<double>> numbers(const Given& given, const char* option, char at, std::size_t least,
                                    std::size_t most, const char* form) {
  std::vector<double> all;
  const std::string text = given.one(option);
  for (const std::string_view part : split(text, at)) {
    const auto number = finite_number(part);
    if (!number) return wrong(option, given, form);
    all.push_back(*number);
  }
  if (all.size() < least || all.size() > most) return wrong(option, given, form);
  return all;
}

}  // namespace hw::app
