#include "core/device/target_check.h"

#include <cmath>

#include <fmt/core.h>

#include "core/device/axis_check.h"
#include "core/device/refusals.h"
#include "core/device/snapshot.h"

namespace hw {

Result<WholePace> check_pace(const Catalog& catalog, const AccelerationUnit& unit, const intent::Pace& pace) {
  const double speed = std::round(pace.speed.value);
  const double slowest = catalog.jog_speed_min.value, fastest = catalog.jog_speed_max.value;
  if (pace.speed.value != 0 && !(speed >= slowest && speed <= fastest))  // negated, so that NaN is refused
    return fail(FaultKind::refused,
                fmt::format("A speed of {} is not possible. The range is {:.0f} to {:.0f} {}/s.",
                            pace.speed.value, slowest, fastest, catalog.step_word),
                "Nothing was sent.");
  const std::int64_t acceleration = pace.acceleration.value_or(0);
  if (pace.acceleration && unit.maximum == 0)
    return fail(FaultKind::refused, "This controller has one ramp for all motions.", "Nothing was sent.");
  if (pace.acceleration && (acceleration < unit.minimum || acceleration > unit.maximum))
    return fail(FaultKind::refused,
                fmt::format("An acceleration of {} is not possible. The range is {} to {} {}.", acceleration,
                            unit.minimum, unit.maximum, unit.unit),
                "Nothing was sent.");
  return WholePace{static_cast<std::int64_t>(speed), acceleration};
}

Result<Steps> check_target(const Catalog& catalog, AxisId axis, Steps from, Steps value) {
  const Steps low = catalog.position_min, high = catalog.position_max;
  std::int64_t target = 0;
  const bool overflows = __builtin_add_overflow(from.value, value.value, &target);
  if (!overflows && Steps(target) >= low && Steps(target) <= high) return Steps(target);
  if (overflows) target = value.value;
  return fail(FaultKind::refused,
              fmt::format("Position {} of {} lies outside its range, {} to {}.", target,
                          spoken_name(catalog, axis.index), low.value, high.value),
              "Nothing was sent.");
}

Result<std::vector<Steps>> check_move(const Catalog& catalog, const Snapshot& now,
                                      const std::vector<AxisTarget>& all, MoveBase base) {
  std::vector<Steps> targets;
  for (const AxisTarget& to : all) {
    if (auto may = check_axis(catalog, to.axis.index); !may) return fail(may.error());
    const Steps from = base == MoveBase::position ? now.axes[to.axis.index].commanded() : Steps(0);
    const auto target = check_target(catalog, to.axis, from, to.value);
    if (!target) return fail(target.error());
    targets.push_back(*target);
  }
  return targets;
}

}  // namespace hw
