#pragma once
// Questions that the next status rounds must ask by command, in addition to their readings.
#include <utility>

#include "core/device/snapshot.h"

namespace hw::vme58 {

class NextRound {
 public:
  explicit NextRound(Snapshot& snapshot) : snapshot_(snapshot) {}

  void asks_flags() { flags_ = true; }
  [[nodiscard]] bool wants_flags() const { return flags_; }
  void flags_were_asked() { flags_ = false; }
  /// A loop may have opened or closed.
  void asks_loops() { loops_ = true; }
  [[nodiscard]] bool wants_loops() const { return loops_; }
  void loops_were_asked() { loops_ = false; }

  /// A command was put that may wait in a queue: the board counts as working until a round sees all queues
  /// empty and no axis turning.
  void awaits_queues() { snapshot_.working = queues_ = true; }
  /// Whether the queues are due: as soon as no axis turns, and then in their turn.
  bool takes_queues(bool turning) {
    const bool due = queues_ && !turning;
    queues_ = turning && (queues_ || snapshot_.working);
    return due;
  }
  void forget() {
    flags_ = true;
    queues_ = snapshot_.working = false;
  }

 private:
  Snapshot& snapshot_;
  bool flags_ = false, loops_ = false, queues_ = false;
};

}  // namespace hw::vme58
