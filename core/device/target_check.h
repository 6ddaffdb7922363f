#pragma once
// Checks a move on any controller before anything is sent: its axes exist, its targets lie in their range,
// and its speed and ramp are possible.
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"

namespace hw {

enum class MoveBase : std::uint8_t { zero, position };

/// The targets in the order of `all`, whose values count from `base`; or why the move is refused. For
/// controllers that have one ramp for all motions.
Result<std::vector<Steps>> check_move(const Catalog& catalog, const Snapshot& now,
                                      const std::vector<AxisTarget>& all, MoveBase base,
                                      const intent::Pace& pace);

}  // namespace hw
