#pragma once
// Programs that a rehearsal has reached but whose text was never read: they are read one after another, and
// the rehearsal is repeated. GUI thread.
#include <functional>
#include <set>

#include "core/device/language.h"
#include "core/device/snapshot.h"

namespace hw::gui {

class UnreadPrograms {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// A rehearsal was requested: each program may be read once for it.
  void begin();
  /// Returns whether the rehearsal reached programs that can still be read. `rehearsed`: the number of its
  /// outcome; each is examined once.
  [[nodiscard]] bool found(const Rehearsal& rehearsal, int rehearsed);
  /// Once a frame: reads the next program. True: nothing more to wait for. Programs that cannot be read stay
  /// unread, and the rehearsal names them.
  [[nodiscard]] bool have_been_read(const Snapshot& now, const Send& send);

 private:
  std::set<int> wanted_, asked_;  ///< slots
  IntentId reading_ = 0;
  int looked_at_ = 0;
};

}  // namespace hw::gui
