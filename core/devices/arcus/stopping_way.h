#pragma once
// How far an axis still moves when stopped with its ramp: Catalog::stopping_way.
#include <optional>

#include "core/device/catalog.h"

namespace hw::arcus {

std::optional<double> stopping_way(const Catalog& catalog, const Snapshot& now, AxisId axis);

}  // namespace hw::arcus
