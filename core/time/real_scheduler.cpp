#include "core/time/real_scheduler.h"

namespace hw {

RealScheduler::RealScheduler(IoContext& io)
    : Scheduler(io), start_(std::chrono::steady_clock::now()), timer_(io.get_executor()) {}

Instant RealScheduler::now() const {
  return Instant(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start_));
}

// The kernel timer is only moved earlier; a disarmed alarm fires without effect. Most alarms are deadlines
// that never come, so this saves two system calls per transaction.
void RealScheduler::first_alarm_moved() {
  if (first_alarm() >= waiting_for_) return;
  wait();
}

void RealScheduler::wait() {
  waiting_for_ = first_alarm();
  timer_.expires_at(start_ + waiting_for_.time_since_epoch());
  timer_.async_wait([this](boost::system::error_code error) {
    if (error) return;
    waiting_for_ = Instant::max();
    fire_due(now());
    if (has_alarms() && first_alarm() < waiting_for_) wait();
  });
}

}  // namespace hw
