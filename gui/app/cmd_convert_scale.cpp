#include "gui/app/cmd_convert_scale.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/session/address.h"
#include "core/session/conversion.h"
#include "core/session/profile.h"
#include "core/session/user_files.h"
#include "gui/app/kept_units.h"
#include "gui/app/option_numbers.h"

namespace hw::app {
namespace {

/// The scale from the unit of length that the console keeps for an axis of the controller at --profile.
Result<double> kept_scale(const Given& given, const Catalog& catalog, const std::string& axis) {
  const auto address = Address::parse(given.one("profile"));
  if (!address) return fail(address.error());
  if (address->model != catalog.model)
    return fail(FaultKind::text,
                fmt::format("--profile {} is not a {}.", given.one("profile"), catalog.model));
  const std::vector<Address> devices = address->devices();
  const int at = catalog.find_axis(axis);
  const bool together = catalog.axes.size() == devices.size() && devices.size() > 1;
  const Address& device = together && at >= 0 ? devices[static_cast<std::size_t>(at)] : devices.front();
  const auto profile =
      ProfileStore(UserFolders::standard()).load(profile_key(device, usb_serial_behind(device)));
  if (!profile) return fail(profile.error());
  const auto unit = at < 0 ? std::nullopt : unit_of_profile(catalog, *profile, together ? 0 : at);
  const auto its = unit ? millimetres(unit->name) : std::nullopt;
  const double ours = *millimetres(given.has("inch") ? "in" : "mm");
  if (!its)
    return fail(
        FaultKind::text,
        fmt::format("The console keeps no unit of length for axis {} of {}.", axis, given.one("profile")), {},
        "Choose one at its number in the console, or write --per-unit instead.");
  if (unit->steps_per_unit < 0)
    return fail(FaultKind::text,
                fmt::format("Axis {} of {} counts opposite to its {}.", axis, given.one("profile"),
                            catalog.step_word),
                {}, "Write --per-unit, and --mirror where the drawing is to be turned round.");
  return unit->steps_per_unit / *its * ours;
}

}  // namespace

Result<std::vector<double>> read_scales(const Given& given, const Catalog& catalog,
                                        const std::vector<std::string>& axes) {
  if (given.has("per-unit") + given.has("step-length") + given.has("profile") > 1)
    return fail(FaultKind::text, "--per-unit, --step-length and --profile mean the same.", {},
                "Write one of them.");
  std::vector<double> scales{1};
  for (const auto& [option, form] :
       {std::pair{"per-unit", "STEPS or STEPS,STEPS"}, std::pair{"step-length", "LENGTH or LENGTH,LENGTH"}}) {
    if (!given.has(option)) continue;
    auto read = numbers(given, option, ',', 1, 2, form);
    if (!read) return fail(read.error());
    if (*std::min_element(read->begin(), read->end()) <= 0) return wrong(option, given, "more than 0");
    scales = std::move(*read);
  }
  if (given.has("step-length"))
    for (double& scale : scales) scale = 1 / scale;
  std::vector<double> all;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto kept = given.has("profile") ? kept_scale(given, catalog, axes[i]) : scales[i % scales.size()];
    if (!kept) return fail(kept.error());
    all.push_back(*kept);
  }
  return all;
}

Result<double> read_pen_scale(const Given& given, const Catalog& catalog, const std::string& axis,
                              double otherwise) {
  if (given.has("pen-per-unit")) return given.number("pen-per-unit", otherwise, 1e-9, 1e12);
  return given.has("profile") ? kept_scale(given, catalog, axis) : otherwise;
}

}  // namespace hw::app
