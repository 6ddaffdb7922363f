#pragma once
// What no reading vouches for any more. Each driver adds what it alone keeps.
#include "core/device/snapshot.h"

namespace hw {

/// The wire is gone: what moved may have ended in any way, and nothing is as it was read. What is kept in the
/// controller (the set-up, its stored programs) is left as it is known.
void nothing_is_known(Snapshot& known);

/// The controller has begun anew, and its set-up with it.
void set_up_is_unknown(Snapshot& known);

}  // namespace hw
