#pragma once
// The values that only some panels show are read in each status round as long as such a panel is drawn, see
// intent::Watch. GUI thread.
#include <cstdint>
#include <functional>

#include "core/device/intent.h"
#include "core/device/snapshot.h"

namespace hw::gui {

class WatchedGroups {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// A panel that shows these values is drawn in this frame. Bit n = group n of Catalog::readout_groups.
  void look_at(std::uint32_t groups) { drawn_ |= groups; }
  /// Negative: none.
  void look_at_group(int group) {
    if (group >= 0) look_at(1u << group);
  }
  /// Once a frame: sends the groups drawn since the last call, if they have changed.
  void report(const Snapshot& now, const Send& send);

 private:
  std::uint32_t drawn_ = 0;  ///< in this frame
  std::uint32_t sent_ = 0;   ///< last, to the session
};

}  // namespace hw::gui
