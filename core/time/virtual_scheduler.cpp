#include "core/time/virtual_scheduler.h"

namespace hw {

void VirtualScheduler::settle() {
  io().restart();
  while (io().poll() > 0) {
  }
}

void VirtualScheduler::run_until(Instant until) {
  run_until(until, [] { return false; });
}

bool VirtualScheduler::run_until(Instant until, const std::function<bool()>& done) {
  for (;;) {
    settle();
    if (done()) return true;
    if (!has_alarms() || first_alarm() > until) break;
    if (first_alarm() > now_) now_ = first_alarm();
    fire_due(now_);
  }
  if (until > now_) now_ = until;
  return false;
}

}  // namespace hw
