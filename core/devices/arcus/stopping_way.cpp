#include "core/devices/arcus/stopping_way.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <string>

#include "core/device/snapshot.h"

namespace hw::arcus {
namespace {

/// The value of the first of these settings that the controller has; none until read.
std::optional<double> setting(const Catalog& catalog, const Snapshot& now,
                              std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    const int i = catalog.find_param(name);
    if (i < 0) continue;
    const ParamState& p = now.params[static_cast<std::size_t>(i)];
    return p.known ? std::optional(static_cast<double>(p.value)) : std::nullopt;
  }
  return {};
}

struct Ramp {
  std::optional<double> high, low, up_ms, down_ms;
  /// An axis uses its own speeds only if it has all of them.
  [[nodiscard]] bool is_set() const {
    return high.value_or(0) > 0 && low.value_or(0) > 0 && up_ms.value_or(0) > 0;
  }
};

}  // namespace

// A ramp takes its time between low and high speed, and proportionally less from another speed. Straight or
// S-shaped, its mean speed is halfway between its ends.
std::optional<double> stopping_way(const Catalog& c, const Snapshot& now, AxisId axis) {
  const double speed = now.axes[axis.index].speed.value;
  if (speed <= 0) return {};
  Ramp ramp{setting(c, now, {"HS", "HSPD"}), setting(c, now, {"LS", "LSPD"}), setting(c, now, {"ACC"}),
            setting(c, now, {"DEC"})};
  const std::string& letter = c.axes[axis.index].name;
  const Ramp own{setting(c, now, {"HS" + letter}), setting(c, now, {"LS" + letter}),
                 setting(c, now, {"ACC" + letter}), setting(c, now, {"DEC" + letter})};
  if (own.is_set()) {
    const auto down_ms = own.down_ms.value_or(0) > 0 ? own.down_ms : ramp.down_ms;
    ramp = own, ramp.down_ms = down_ms;
  }
  const bool separate = setting(c, now, {"EDEC"}).value_or(0) != 0;
  const auto ms = separate ? ramp.down_ms : ramp.up_ms;
  if (!ramp.high || !ramp.low || !ms) return {};
  if (speed <= *ramp.low || *ramp.high <= *ramp.low) return 0;
  const double time = *ms / 1000 * (speed - *ramp.low) / (*ramp.high - *ramp.low);
  const double way = (speed + *ramp.low) / 2 * time;
  const AxisState& a = now.axes[axis.index];  // speed and position are not of the same moment
  if (!a.has_target) return way;
  return std::min(way, static_cast<double>(std::llabs((a.target - a.commanded()).value)));
}

}  // namespace hw::arcus
