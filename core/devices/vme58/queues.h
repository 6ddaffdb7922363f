#pragma once
// The board's command queues: one for each axis, one for AA and one for AM (decision M20).
#include <functional>

#include "core/device/catalog.h"
#include "core/devices/vme58/conversation.h"

namespace hw::vme58 {

class Queues {
 public:
  struct Room {
    unsigned all_free = 0;                   ///< bit per empty queue; AA's and AM's after those of the axes
    bool were_empty = false, empty = false;  ///< all queues, at the previous reading and now
  };
  Queues(const Catalog& catalog, const Selection& selection, Conversation& conversation, Snapshot& snapshot)
      : catalog_(catalog), selection_(selection), conversation_(conversation), snapshot_(snapshot) {}

  /// Reads the queues. A full ring or a WQ holds questions back: the queues are then unknown, without a
  /// fault.
  Task<Result<>> read(Priority priority);
  /// All queues were empty when last read.
  [[nodiscard]] bool empty() const { return empty_; }
  /// At least one queue is known from the last reading.
  [[nodiscard]] bool known() const { return snapshot_.queue_known != 0; }
  /// The board reads no further: no queue can be read. Shows as full the queue that the latest text
  /// addresses, as it has fewer free entries than the text takes.
  void show_full();
  void forget();

  /// Called after each reading.
  std::function<void(const Room&)> were_read;

 private:
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }
  Result<> take(const std::vector<std::string>& replies, bool were_empty);

  const Catalog& catalog_;
  const Selection& selection_;
  Conversation& conversation_;
  Snapshot& snapshot_;
  bool empty_ = false;
};

}  // namespace hw::vme58
