#pragma once
// The sleep of this computer, as systemd-logind tells of it: a held jog is let go before, nothing sleeps
// while something moves, and afterwards everything is read afresh. Where there is no logind, none of that
// happens.
#include <functional>
#include <memory>

#include "core/time/scheduler.h"

namespace hw {

class SleepWatch {
 public:
  /// Both are called on the io thread.
  struct Heard {
    /// The computer waits for may_sleep(), for some seconds at most.
    std::function<void()> wants_to_sleep;
    std::function<void()> has_woken;
  };
  SleepWatch(Scheduler& scheduler, Heard heard);
  /// When the io thread has ended, or on it.
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
