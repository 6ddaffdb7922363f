#pragma once
// The smallest plan that still breaks the same law.
#include <functional>

#include "tests/simulation/plan.h"

namespace hw::simulation {

/// `fails` runs a plan and answers whether it still finds the same.
Plan shrink(Plan plan, const std::function<bool(const Plan&)>& fails);

}  // namespace hw::simulation
