#include "core/devices/vme58/staircase_text.h"

#include <cmath>

#include <fmt/format.h>

#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

// MP and MM say which way, MV runs at a speed up to a position, SP comes to rest (decision M84).
Result<std::string> staircase_text(const StaircasePlan& plan, const Catalog& catalog) {
  if (auto fine = check_staircase(plan, catalog); !fine) return fail(fine.error());
  std::string text =
      fmt::format("A{}\n{}\n", axis_letters[plan.axis.index], plan.stop_at > plan.from ? "MP" : "MM");
  for (const StaircaseStep& s : plan.steps)
    text += fmt::format("MV{},{};\n", s.until.value, std::llround(s.speed.value));
  return text + fmt::format("SP{};\n", plan.stop_at.value);
}

}  // namespace hw::vme58
