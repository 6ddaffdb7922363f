#pragma once
// Checks a move on any controller before anything is sent: its axes exist, its targets lie in their range,
// and its speed and ramp are possible.
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/registry.h"

namespace hw {

/// Speed and acceleration of one motion, in the whole numbers that controllers take; 0: their own.
struct WholePace {
  std::int64_t speed = 0, acceleration = 0;
};

/// Rounds the pace to whole numbers; the fault says why it is refused. A unit without a range: the controller
/// has one ramp for all motions.
Result<WholePace> check_pace(const Catalog& catalog, const AccelerationUnit& unit, const intent::Pace& pace);

/// `from` + `value`, if the axis can go there.
Result<Steps> check_target(const Catalog& catalog, AxisId axis, Steps from, Steps value);

enum class MoveBase : std::uint8_t { zero, position };

/// The targets in the order of `all`, whose values count from `base`; or why the move is refused.
Result<std::vector<Steps>> check_move(const Catalog& catalog, const Snapshot& now,
                                      const std::vector<AxisTarget>& all, MoveBase base);

}  // namespace hw
