#include "core/device/param_check.h"

#include <fmt/core.h>

namespace hw {
namespace {

std::string plain(const ParamInfo&, std::int64_t value) { return fmt::format("{}", value); }

std::string range_words(const ParamInfo& info, decltype(ParamRules::write) write) {
  if (info.choices.empty())
    return fmt::format("{} to {}{}", write(info, info.minimum), write(info, info.maximum),
                       info.also_zero ? ", or 0" : "");
  std::string all;
  for (const ParamChoice& c : info.choices) all += fmt::format("{}{}", all.empty() ? "" : ", ", c.value);
  return "one of " + all;
}

}  // namespace

Result<std::size_t> check_param(const Catalog& catalog, const intent::SetParam& request,
                                const ParamRules& rules) {
  const int place = catalog.find_param(request.mnemonic);
  if (place < 0)
    return fail(FaultKind::refused, fmt::format("{} has no parameter {}.", rules.title, request.mnemonic),
                "Nothing was sent.");
  const ParamInfo& info = catalog.params[static_cast<std::size_t>(place)];
  const auto write = rules.write != nullptr ? rules.write : plain;
  if (!info.accepts(request.value))
    return fail(FaultKind::refused,
                fmt::format("{} is not possible for {} ({}): it takes {}.", write(info, request.value),
                            info.mnemonic, info.label, range_words(info, write)),
                "Nothing was sent.");
  if (rules.may_now)
    if (auto may = rules.may_now(info); !may) return fail(may.error());
  if (!info.warning.empty() && !request.confirmed && request.value != info.harmless)
    return fail(FaultKind::refused, info.warning, "Nothing was sent.", "Confirm it to go on.");
  return static_cast<std::size_t>(place);
}

}  // namespace hw
