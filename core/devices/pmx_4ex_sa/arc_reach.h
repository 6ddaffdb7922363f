#pragma once
// The extent of an arc of X and Y from the present positions. PMX manual ch. 6.
#include <cstdint>
#include <vector>

#include "core/device/snapshot.h"

namespace hw::pmx_4ex_sa {

/// The least and the greatest position of each axis. `values`: of the action "arc".
std::vector<AxisTarget> arc_reaches(const Snapshot& now, const std::vector<std::int64_t>& values);

}  // namespace hw::pmx_4ex_sa
