#pragma once
// What is refused of an action before its driver sees it.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"

namespace hw {

/// That there is such an action, and that each of its fields takes its value.
Result<> check_action(const Catalog& catalog, const intent::Act& wish);

}  // namespace hw
