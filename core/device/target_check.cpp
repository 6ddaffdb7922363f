#include "core/device/target_check.h"

#include <fmt/core.h>

#include "core/device/snapshot.h"

namespace hw {
namespace {

Result<> check_pace(const Catalog& catalog, const intent::Pace& pace) {
  if (pace.acceleration)
    return fail(FaultKind::refused, "This controller has one ramp for all motions.", "Nothing was sent.");
  const double speed = pace.speed.value;
  if (speed == 0 || (speed >= catalog.jog_speed_min.value && speed <= catalog.jog_speed_max.value)) return {};
  return fail(FaultKind::refused,
              fmt::format("{:.0f} {}/s is not a possible speed. The range is {:.0f} to {:.0f}.", speed,
                          catalog.step_word, catalog.jog_speed_min.value, catalog.jog_speed_max.value),
              "Nothing was sent.");
}

}  // namespace

Result<std::vector<Steps>> check_move(const Catalog& catalog, const Snapshot& now,
                                      const std::vector<AxisTarget>& all, MoveBase base,
                                      const intent::Pace& pace) {
  if (const auto possible = check_pace(catalog, pace); !possible) return fail(possible.error());
  std::vector<Steps> targets;
  for (const AxisTarget& to : all) {
    if (to.axis.index >= catalog.axes.size())
      return fail(FaultKind::refused, fmt::format("There is no axis {}.", to.axis.index + 1),
                  "Nothing was sent.");
    const std::int64_t from = base == MoveBase::position ? now.axes[to.axis.index].commanded().value : 0;
    std::int64_t target = 0;
    if (!__builtin_add_overflow(from, to.value.value, &target) && Steps(target) >= catalog.position_min &&
        Steps(target) <= catalog.position_max) {
      targets.emplace_back(target);
      continue;
    }
    return fail(FaultKind::refused,
                fmt::format("{} {} from {} is out of the range of axis {}, {} to {}.", to.value.value,
                            catalog.step_word, from, catalog.axes[to.axis.index].name,
                            catalog.position_min.value, catalog.position_max.value),
                "Nothing was sent.");
  }
  return targets;
}

}  // namespace hw
