#pragma once
// Contours and velocity staircases as command strings (data sheet, "Contouring" and "Velocity staircase").
#include "core/device/contour_plan.h"

namespace hw::vme58 {

Result<std::string> contour_text(const ContourPlan& plan, const Catalog& catalog);
Result<std::string> staircase_text(const StaircasePlan& plan, const Catalog& catalog);
/// Those that AN and AF switch within a contour: the auxiliary outputs.
std::vector<int> contour_outputs(const Catalog& catalog);

}  // namespace hw::vme58
