#pragma once
// The jogs that were asked for and not let go yet. Which of them ends is decided by name: what becomes of
// another command, or a stop of another axis, leaves a held jog guarded. io thread.
#include <algorithm>
#include <vector>

#include "core/device/intent.h"

namespace hw {

class HeldJogs {
 public:
  /// `guarded`: held by a hand, which must keep it alive.
  void begin(IntentId id, int axis, bool guarded) { jogs_.push_back({id, axis, guarded}); }
  /// It has not begun after all.
  void end(IntentId id) {
    std::erase_if(jogs_, [id](const Jog& jog) { return jog.id == id; });
  }
  /// -1: all axes.
  void stop(int axis) {
    std::erase_if(jogs_, [axis](const Jog& jog) { return axis < 0 || jog.axis == axis; });
  }
  /// The one that a driver's stop_jog() ends.
  void stop_latest() {
    if (any()) stop(jogs_.back().axis);
  }

  /// 0: none is held.
  [[nodiscard]] IntentId latest() const { return any() ? jogs_.back().id : 0; }
  [[nodiscard]] bool any() const { return !jogs_.empty(); }
  [[nodiscard]] bool has(IntentId id) const {
    return std::any_of(jogs_.begin(), jogs_.end(), [id](const Jog& jog) { return jog.id == id; });
  }
  [[nodiscard]] bool any_guarded() const {
    return std::any_of(jogs_.begin(), jogs_.end(), [](const Jog& jog) { return jog.guarded; });
  }

 private:
  struct Jog {
    IntentId id;
    int axis;
    bool guarded;
  };
  std::vector<Jog> jogs_;
};

}  // namespace hw
