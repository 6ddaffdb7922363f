#pragma once
// The board's command queues: of each axis, and those of AA and AM beside them (decision M20).
#include <functional>

#include "core/device/catalog.h"
#include "core/devices/vme58/conversation.h"

namespace hw::vme58 {

class Queues {
 public:
  struct Room {
    unsigned all_free =
        0;  ///< bit per queue that holds nothing; AA's and AM's stand behind those of the axes
    bool were_empty = false, empty = false;  ///< all of them, before this and now
  };
  Queues(const Catalog& catalog, const Selection& selection, Conversation& conversation, Snapshot& draft)
      : catalog_(catalog), selection_(selection), conversation_(conversation), draft_(draft) {}

  /// A full ring or a WQ holds questions back: nothing is known then, and that is no fault.
  Task<Result<>> read(Priority priority);
  /// All of them, when last asked.
  [[nodiscard]] bool empty() const { return empty_; }
  /// Something was heard of them then.
  [[nodiscard]] bool known() const { return draft_.queue_known != 0; }
  /// The board reads no further: no queue can be asked for, and the one that the text is meant for is full
  /// (what waits does not fit: fewer entries are free than it takes).
  void show_full();
  void forget();

  /// Whoever makes something of it.
  std::function<void(const Room&)> were_read;

 private:
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }
  Result<> take(const std::vector<std::string>& replies, bool were_empty);

  const Catalog& catalog_;
  const Selection& selection_;
  Conversation& conversation_;
  Snapshot& draft_;
  bool empty_ = false;
};

}  // namespace hw::vme58
