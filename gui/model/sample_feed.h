#pragma once
// The samples of a recording (intent::Sample) on their way from a session to the panel that shows them.
#include <functional>

#include "core/device/snapshot.h"

namespace hw::gui {

class Tab;

/// Hands each sample that has come since the last call to `take`, oldest first. Without a session: none.
void take_samples(Tab& tab, const std::function<void(const AxisSample&)>& take);

}  // namespace hw::gui
