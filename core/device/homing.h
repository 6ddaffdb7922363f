#pragma once
// Ways of homing on any controller: what is refused before its driver is asked, and which way makes a
// doubtful count known again.
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"

namespace hw {

/// Why this mode does not go in that direction, as a sentence; empty: it does, or there is no such mode.
std::string why_not_home(const Catalog& catalog, int mode, Sign sign);

/// Refuses an axis, a mode and a direction that the controller does not have.
Result<> check_home(const Catalog& catalog, const intent::Home& request);

/// The mode to be used in that direction to make the count known: the chosen one, if it sets the count, else
/// the first one that does. Where none sets it, one that goes that way at all; none: no mode does.
std::optional<int> homing_that_sets(const Catalog& catalog, int chosen, Sign sign);

}  // namespace hw
