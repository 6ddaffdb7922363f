#pragma once
#include "core/device/snapshot.h"

namespace hw {

/// Everything that the user sees is equal; times and counters may differ. Traffic is in the record, which
/// wakes the reader itself.
bool looks_same(const Snapshot& a, const Snapshot& b);

}  // namespace hw
