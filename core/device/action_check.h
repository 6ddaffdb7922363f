#pragma once
// Checks an action before its driver sees it.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"

namespace hw {

/// Refuses an unknown action, and a value that its field does not take.
Result<> check_action(const Catalog& catalog, const intent::Act& request);

}  // namespace hw
