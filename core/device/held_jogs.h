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
  /// Those of scripts that `over(id, axis)` says have ended by themselves: at a limit.
  template <class Over>
  void forget_if(Over over) {
    std::erase_if(jogs_, [&](const Jog& jog) { return !jog.guarded && over(jog.id, jog.axis); });
  }
  template <class Each>
  void for_each_axis(Each each) const {
    for (const Jog& jog : jogs_) each(jog.axis);
  }
  [[nodiscard]] bool any() const { return !jogs_.empty(); }
  [[nodiscard]] bool has(IntentId id) const {
    return std::any_of(jogs_.begin(), jogs_.end(), [id](const Jog& jog) { return jog.id == id; });
  }
  [[nodiscard]] bool any_guarded() const {
    return std::any_of(jogs_.begin(), jogs_.end(), [](const Jog& jog) { return jog.guarded; });
  }

  struct Jog {
    IntentId id = 0;  ///< 0: none is held
    int axis = -1;
    bool guarded = false;
  };
  /// The one that ends when a hand lets go: its own, whatever a script has begun meanwhile.
  [[nodiscard]] Jog in_hand() const {
    const auto own = std::find_if(jogs_.rbegin(), jogs_.rend(), [](const Jog& jog) { return jog.guarded; });
    return own != jogs_.rend() ? *own : Jog();
  }

 private:
  std::vector<Jog> jogs_;
};

}  // namespace hw
