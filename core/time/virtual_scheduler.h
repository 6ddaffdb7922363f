#pragma once
#include "core/time/scheduler.h"

namespace hw {

/// Time that stands still until it is moved. Posted work runs to its end before time goes on, so that a
/// session replays in the same order every time.
class VirtualScheduler final : public Scheduler {
 public:
  explicit VirtualScheduler(IoContext& io) : Scheduler(io) {}
  [[nodiscard]] Instant now() const override { return now_; }

  /// Runs all work and alarms up to `until`; afterwards now() == until.
  void run_until(Instant until);
  void run_for(Duration d) { run_until(now_ + d); }
  /// Runs until `done` returns true or `until` is reached; true if done.
  bool run_until(Instant until, const std::function<bool()>& done);

 private:
  void first_alarm_moved() override {}
  void settle();

  Instant now_{};
};

}  // namespace hw
