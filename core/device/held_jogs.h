#pragma once
// The held jogs, and the dead-man timer that ends a user's jog when the console no longer confirms it. Jogs
// are identified by intent: the outcome of another command, or a stop of another axis, leaves a held jog
// guarded. Io thread.
#include <algorithm>
#include <functional>
#include <vector>

#include "core/device/intent.h"
#include "core/time/scheduler.h"

namespace hw {

class HeldJogs {
 public:
  static constexpr Duration patience = Millis(250);

  HeldJogs(Scheduler& scheduler, std::function<void()> not_held_any_more)
      : scheduler_(scheduler), dead_man_(scheduler, std::move(not_held_any_more)) {}

  /// `guarded`: held by the user, and must be kept alive.
  void begin(IntentId id, int axis, bool guarded) {
    jogs_.push_back({id, axis, guarded});
    if (guarded) dead_man_.arm(scheduler_.now() + patience);
  }
  void keep_alive() {
    if (any() && dead_man_.armed()) dead_man_.arm(scheduler_.now() + patience);
  }
  /// The jog did not begin.
  void end(IntentId id) {
    std::erase_if(jogs_, [id](const Jog& jog) { return jog.id == id; });
    disarm_if_none_is_guarded();
  }
  /// -1: all axes.
  void stop(int axis) {
    std::erase_if(jogs_, [axis](const Jog& jog) { return axis < 0 || jog.axis == axis; });
    disarm_if_none_is_guarded();
  }
  /// Forgets a script's jogs that have ended by themselves, at a limit, as `over(id, axis)` reports.
  template <class Over>
  void forget_if(Over over) {
    std::erase_if(jogs_, [&](const Jog& jog) { return !jog.guarded && over(jog.id, jog.axis); });
  }
  template <class Each>
  void for_each_axis(Each each) const {
    for (const Jog& jog : jogs_) each(jog.axis);
  }
  /// The axes of jogs that `has_begun(id)`.
  template <class Begun>
  [[nodiscard]] std::vector<int> axes_if(Begun has_begun) const {
    std::vector<int> axes;
    for (const Jog& jog : jogs_)
      if (has_begun(jog.id)) axes.push_back(jog.axis);
    return axes;
  }
  [[nodiscard]] bool any() const { return !jogs_.empty(); }
  [[nodiscard]] bool has(IntentId id) const {
    return std::any_of(jogs_.begin(), jogs_.end(), [id](const Jog& jog) { return jog.id == id; });
  }
  /// A bit for each axis that the user jogs and whose jog `has_begun(id)`.
  template <class Begun>
  [[nodiscard]] unsigned guarded_axes_if(Begun has_begun) const {
    unsigned axes = 0;
    for (const Jog& jog : jogs_)
      if (jog.guarded && has_begun(jog.id)) axes |= 1u << jog.axis;
    return axes;
  }
  [[nodiscard]] bool any_guarded() const {
    return std::any_of(jogs_.begin(), jogs_.end(), [](const Jog& jog) { return jog.guarded; });
  }

  struct Jog {
    IntentId id = 0;  ///< 0: none is held
    int axis = -1;
    bool guarded = false;
  };
  /// The jog that ends when the user lets go: the user's own, not a script's.
  [[nodiscard]] Jog in_hand() const {
    const auto own = std::find_if(jogs_.rbegin(), jogs_.rend(), [](const Jog& jog) { return jog.guarded; });
    return own != jogs_.rend() ? *own : Jog();
  }

 private:
  void disarm_if_none_is_guarded() {
    if (!any_guarded()) dead_man_.disarm();
  }

  Scheduler& scheduler_;
  std::vector<Jog> jogs_;
  Timer dead_man_;
};

}  // namespace hw
