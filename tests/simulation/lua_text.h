#pragma once
// A plan as a script for `handwheel run`, as far as scripts can express it; the rest stands there as remarks.
#include <string>

#include "tests/simulation/plan.h"

namespace hw::simulation {

std::string lua_script(const Plan& plan);

}  // namespace hw::simulation
