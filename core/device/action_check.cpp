#include "core/device/action_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"

namespace hw {
namespace {

std::string number(std::int64_t value, int decimals) {
  return fmt::format("{:.{}f}", static_cast<double>(value) / std::pow(10, decimals), decimals);
}

bool takes(const ActionField& field, std::int64_t value) {
  const auto& choices = field.choices;
  if (choices.empty()) return value >= field.minimum && value <= field.maximum;
  return std::any_of(choices.begin(), choices.end(), [&](const ParamChoice& c) { return c.value == value; });
}

std::string accepted_values(const ActionField& field) {
  if (field.choices.empty())
    return fmt::format("{} to {}", number(field.minimum, field.decimals),
                       number(field.maximum, field.decimals));
  std::string all;
  for (const ParamChoice& c : field.choices) all += fmt::format("{}{}", all.empty() ? "" : ", ", c.value);
  return all;
}

}  // namespace

Result<> check_action(const Catalog& catalog, const intent::Act& request) {
  if (request.action < 0 || request.action >= static_cast<int>(catalog.actions.size()))
    return fail(FaultKind::refused, "There is no such action.", "Nothing was sent.");
  const ActionInfo& info = catalog.actions[ix(request.action)];
  if (request.values.size() != info.fields.size())
    return fail(
        FaultKind::refused,
        fmt::format("{} takes {} values, not {}.", info.label, info.fields.size(), request.values.size()),
        "Nothing was sent.");
  for (std::size_t i = 0; i < request.values.size(); ++i) {
    const ActionField& field = info.fields[i];
    if (takes(field, request.values[i])) continue;
    return fail(
        FaultKind::refused,
        fmt::format("{} is not possible as {} of {}. It takes {}.", number(request.values[i], field.decimals),
                    field.label, info.label, accepted_values(field)),
        "Nothing was sent.");
  }
  return {};
}

}  // namespace hw
