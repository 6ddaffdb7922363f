#include "core/device/staircase_plan.h"

#include <utility>

#include <fmt/format.h>

namespace hw {

static bool in_range(const Catalog& c, Steps s) { return s >= c.position_min && s <= c.position_max; }

Result<> check_staircase(const StaircasePlan& plan, const Catalog& c) {
  const auto wrong = [](std::string why) {
    return fail(FaultKind::text, std::move(why), "Nothing was sent.");
  };
  if (plan.steps.empty()) return wrong("The staircase has no step.");
  if (plan.stop_at == plan.from) return wrong("It stops where the axis stands.");
  const bool up = plan.stop_at > plan.from;
  Steps before = plan.from;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const StaircaseStep& s = plan.steps[i];
    if (s.speed.value < 1 || s.speed > c.jog_speed_max)
      return wrong(fmt::format("Step {}: the speed goes from 1 to {} {}/s.", i + 1, c.jog_speed_max.value,
                               c.step_word));
    if (s.until == before || (s.until > before) != up)
      return wrong(fmt::format("Step {}: {} does not lie on the way from {} to {}.", i + 1, s.until.value,
                               before.value, plan.stop_at.value));
    before = s.until;
  }
  if (!in_range(c, plan.stop_at))
    return wrong(fmt::format("Positions go from {} to {}.", c.position_min.value, c.position_max.value));
  if ((plan.stop_at > before) != up || plan.stop_at == before)
    return wrong(
        fmt::format("It has passed {} when the last step ends at {}.", plan.stop_at.value, before.value));
  return {};
}

}  // namespace hw
