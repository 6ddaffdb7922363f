#pragma once
// The way that an axis still goes when it is stopped, for Catalog::stopping_way.
#include <optional>

#include "core/base/units.h"

namespace hw {

struct Catalog;
struct Snapshot;

/// For a driver that knows the ramp of each motion (AxisState::ramp). With a ramp, an axis goes at most as
/// far as it has come since its motion began, and no further than its target. Nothing where the ramp is not
/// known.
std::optional<double> stopping_way_by_ramp(const Catalog& catalog, const Snapshot& now, AxisId axis);

}  // namespace hw
