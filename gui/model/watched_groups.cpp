#include "gui/model/watched_groups.h"

#include <utility>

namespace hw::gui {

// After a lost link, the controller has forgotten nothing, but its driver may have: the groups are sent
// again.
void WatchedGroups::report(const Snapshot& now, const Send& send) {
  const std::uint32_t groups = std::exchange(drawn_, 0);
  const bool there = now.link.state == LinkState::good || now.link.state == LinkState::late;
  if (!there) {
    sent_ = 0;
    return;
  }
  if (groups == sent_) return;
  sent_ = groups;
  send(intent::Watch(groups));
}

}  // namespace hw::gui
