#pragma once
// Follows this computer's sleep through systemd-logind. A held jog is released before sleep, sleep is
// inhibited while an axis moves, and all values are read again after waking. Without logind it does nothing.
#include <functional>
#include <memory>

#include "core/time/scheduler.h"

namespace hw {

class SleepWatch {
 public:
  /// Both functions are called on the io thread.
  struct Callbacks {
    /// The computer is about to sleep. It waits at most a few seconds for may_sleep().
    std::function<void()> wants_to_sleep;
    std::function<void()> has_woken;
  };
  SleepWatch(Scheduler& scheduler, Callbacks callbacks);
  /// Call on the io thread, or after it has ended.
  ~SleepWatch();
  SleepWatch(const SleepWatch&) = delete;
  SleepWatch& operator=(const SleepWatch&) = delete;

  // ---- any thread
  void may_sleep();
  void keep_awake(bool something_moves);

 private:
  class Logind;
  Scheduler& scheduler_;
  std::shared_ptr<Logind> logind_;
};

}  // namespace hw
