#pragma once
#include <chrono>

#include "core/time/scheduler.h"

namespace hw {

/// Virtual time that can become wall-clock time while it runs: a script starts with emulators and then opens
/// a real port. One thread drives it, turn by turn, in both kinds of time.
class HybridScheduler final : public Scheduler {
 public:
  HybridScheduler(IoContext& io, bool real);

  [[nodiscard]] Instant now() const override;
  [[nodiscard]] bool is_real() const { return real_; }
  /// From here on now() follows the wall clock. It cannot be undone.
  void go_real();

  enum class Turn {
    done,   ///< `done` returned true
    time,   ///< `until` is reached
    stuck,  ///< virtual time, and nothing is left to happen
  };
  /// Runs work and alarms. Virtual time stands still while work runs; wall-clock time waits for bytes too.
  Turn run_until(Instant until, const std::function<bool()>& done);

 private:
  void first_alarm_moved() override {}  // checked in every turn
  void settle();
  void work_until_alarm(Instant until);
  Turn virtual_turns(Instant until, const std::function<bool()>& done);
  Turn real_turns(Instant until, const std::function<bool()>& done);

  bool real_ = false;
  Instant virtual_now_{};
  std::chrono::steady_clock::time_point real_since_;
  asio::executor_work_guard<Executor> waits_for_bytes_;
};

}  // namespace hw
