#pragma once
// Follows this computer's sleep through systemd-logind: a held jog is released before sleep, sleep is
// inhibited while something moves, and everything is read again after waking. Without logind nothing is done.
#include <functional>
#include <memory>

#include "core/time/scheduler.h"

namespace hw {

class SleepWatch {
 public:
  /// Both are called on the io thread.
  struct Callbacks {
    /// The computer waits a few seconds at most for may_sleep().
    std::function<void()> wants_to_sleep;
    std::function<void()> has_woken;
  };
  SleepWatch(Scheduler& scheduler, Callbacks callbacks);
  /// On the io thread, or after it has ended.
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
