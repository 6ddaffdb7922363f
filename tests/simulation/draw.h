#pragma once
// A plan from a seed.
#include <cstdint>
#include <string_view>

#include "tests/simulation/plan.h"

namespace hw::simulation {

struct Drawing {
  Millis length{60'000};
  bool faults = true;  ///< false: the wire is good and the machine does as it is told
  bool bus = false;    ///< several devices on the line, where the model can
};

Plan draw_plan(std::string_view model, std::uint64_t seed, const Drawing& drawing);

}  // namespace hw::simulation
