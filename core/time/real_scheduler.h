#pragma once
#include "core/time/scheduler.h"

namespace hw {

/// Wall-clock time (steady clock), counted from construction.
class RealScheduler final : public Scheduler {
 public:
  explicit RealScheduler(IoContext& io);
  [[nodiscard]] Instant now() const override;

 private:
  void first_alarm_moved() override;
  void wait();

  std::chrono::steady_clock::time_point start_;
  asio::basic_waitable_timer<std::chrono::steady_clock, asio::wait_traits<std::chrono::steady_clock>,
                             Executor>
      timer_;
  Instant waiting_for_ = Instant::max();
};

}  // namespace hw
