#pragma once
// The distance that an axis still travels when it is stopped, for Catalog::stopping_way.
#include <optional>

#include "core/base/units.h"

namespace hw {

struct Catalog;
struct Snapshot;

/// In steps, for a driver that knows the ramp of each motion (AxisState::ramp). The axis travels at most as
/// far as it has come since its motion began, and no further than its target. None: the ramp is not known.
std::optional<double> stopping_way_by_ramp(const Catalog& catalog, const Snapshot& now, AxisId axis);

}  // namespace hw
