#pragma once
// Checks of homing on any controller, before its driver is asked and by that driver, and the choice of the
// mode that makes a doubtful count known again.
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"

namespace hw {

/// Why this mode cannot home in that direction, as a sentence; empty: it can, or there is no such mode.
std::string why_not_home(const Catalog& catalog, int mode, Sign sign);

/// Refuses an axis, a mode and a direction that the controller does not have.
Result<> check_home(const Catalog& catalog, const intent::Home& request);

/// The mode that makes the count known by homing in that direction: the chosen mode, if it sets the count,
/// else the first that does. If no mode sets it, any mode in that direction; none: there is none.
std::optional<int> homing_that_sets(const Catalog& catalog, int chosen, Sign sign);

}  // namespace hw
