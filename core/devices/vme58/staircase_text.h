#pragma once
// Velocity staircases as command strings (data sheet, "Velocity staircase").
#include "core/device/staircase_plan.h"

namespace hw::vme58 {

Result<std::string> staircase_text(const StaircasePlan& plan, const Catalog& catalog);

}  // namespace hw::vme58
