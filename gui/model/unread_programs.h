#pragma once
// Programs that a rehearsal has reached but whose text was never read, and variables that it has read and
// that are not known: they are read one after another, and the rehearsal is repeated. GUI thread.
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "core/device/language.h"
#include "core/device/snapshot.h"

namespace hw::gui {

class UnreadPrograms {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// A rehearsal was requested: each program may be read once for it.
  void begin();
  /// Returns whether the rehearsal came to a program or variable that can still be read. `rehearsed`: the
  /// number of its outcome; each is examined once. `variable`: what the name of a variable begins with;
  /// empty: there are none.
  [[nodiscard]] bool found(const Rehearsal& rehearsal, int rehearsed, std::string_view variable);
  /// Once a frame: reads the next program. True: nothing more to wait for. Programs that cannot be read stay
  /// unread, and the rehearsal names them.
  [[nodiscard]] bool have_been_read(const Snapshot& now, const Send& send);

 private:
  std::set<int> wanted_, asked_;  ///< slots
  /// By name; each is asked for once, as they may change while a program runs.
  std::set<std::string, std::less<>> wanted_variables_, asked_variables_;
  IntentId reading_ = 0;
  int looked_at_ = 0;
};

}  // namespace hw::gui
