#pragma once
// Programs that a rehearsal has come to and whose text nobody has read: they are read, one after the other,
// and it is rehearsed again. GUI thread.
#include <functional>
#include <set>

#include "core/device/language.h"
#include "core/device/snapshot.h"

namespace hw::gui {

class UnreadPrograms {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// A rehearsal is asked for: each program may be read once for it.
  void begin();
  /// It has come to some that can be read still. `rehearsed`: the number of its outcome, looked at once.
  [[nodiscard]] bool found(const Rehearsal& rehearsal, int rehearsed);
  /// Once a frame: what is to be read is read. True: nothing is waited for any more. What cannot be read
  /// stays unread, and is named by the rehearsal.
  [[nodiscard]] bool have_been_read(const Snapshot& now, const Send& send);

 private:
  std::set<int> wanted_, asked_;  ///< slots
  IntentId reading_ = 0;
  int looked_at_ = 0;
};

}  // namespace hw::gui
