#pragma once
// Whether a controller has an axis.
#include <string>

#include "core/base/result.h"

namespace hw {

struct Catalog;

/// "There is no axis 3." Axes count from 0 here.
std::string describe_no_axis(int axis);
/// Refuses an axis that the controller does not have.
Result<> check_axis(const Catalog& catalog, int axis);

}  // namespace hw
