#pragma once
// Marks state as unknown when no reading supports it any more. Each driver adds its own state.
#include "core/device/snapshot.h"

namespace hw {

/// The wire is gone: motions may have ended in any way, and no reading is valid. The set-up and the stored
/// programs stay as known.
void nothing_is_known(Snapshot& known);

/// The controller has restarted, so its set-up is unknown too.
void set_up_is_unknown(Snapshot& known);

}  // namespace hw
