#include "core/device/homing.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_check.h"

namespace hw {
namespace {

const HomingMode* find_mode(const Catalog& catalog, int mode) {
  const bool known = mode >= 0 && mode < static_cast<int>(catalog.homing_modes.size());
  return known ? &catalog.homing_modes[ix(mode)] : nullptr;
}

}  // namespace

std::string why_not_home(const Catalog& catalog, int mode, Sign sign) {
  const HomingMode* found = find_mode(catalog, mode);
  if (!found || found->allows(sign)) return {};
  return fmt::format("Homing {} runs only in the {} direction.", found->label,
                     sign == Sign::plus ? "\u2212" : "+");
}

Result<> check_home(const Catalog& catalog, const intent::Home& request) {
  if (auto may = check_axis(catalog, request.axis.index); !may) return may;
  if (!catalog.can.homes)
    return fail(FaultKind::refused, fmt::format("A {} has no homing.", catalog.short_name),
                "Nothing was sent.");
  const bool only_one = catalog.homing_modes.empty() && request.mode == 0;  // the only mode has no name
  if (!only_one && !find_mode(catalog, request.mode))
    return fail(FaultKind::refused, fmt::format("There is no homing mode number {}.", request.mode),
                "Nothing was sent.");
  if (std::string why = why_not_home(catalog, request.mode, request.sign); !why.empty())
    return fail(FaultKind::refused, std::move(why), "Nothing was sent.", "Home it in that direction.");
  return {};
}

std::optional<int> homing_that_sets(const Catalog& catalog, int chosen, Sign sign) {
  if (catalog.homing_modes.empty()) return 0;
  std::optional<int> possible;
  const auto sets = [&](int mode) {
    const HomingMode* found = find_mode(catalog, mode);
    if (!found || !found->allows(sign)) return false;
    if (!possible) possible = mode;
    return found->sets_position;
  };
  if (sets(chosen)) return chosen;
  for (int mode = 0; find_mode(catalog, mode); ++mode)
    if (sets(mode)) return mode;
  return possible;
}

}  // namespace hw
