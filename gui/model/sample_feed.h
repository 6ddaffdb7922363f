#pragma once
// Passes the samples of a recording (intent::Sample) from a session to the panel that shows them.
#include <functional>

#include "core/device/snapshot.h"

namespace hw::gui {

class Tab;

/// Hands each sample received since the last call to `take`, oldest first. Without a session: none.
void take_samples(Tab& tab, const std::function<void(const AxisSample&)>& take);

}  // namespace hw::gui
