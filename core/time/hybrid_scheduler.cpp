#include "core/time/hybrid_scheduler.h"

#include <algorithm>

namespace hw {

HybridScheduler::HybridScheduler(IoContext& io, bool real)
    : Scheduler(io), waits_for_bytes_(io.get_executor()) {
  if (real) go_real();
}

Instant HybridScheduler::now() const {
  if (!real_) return virtual_now_;
  return virtual_now_ + std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - real_since_);
}

void HybridScheduler::go_real() {
  if (real_) return;
  real_since_ = std::chrono::steady_clock::now();
  real_ = true;
}

void HybridScheduler::settle() {
  while (io().poll() > 0) {
  }
}

HybridScheduler::Turn HybridScheduler::run_until(Instant until, const std::function<bool()>& done) {
  if (!real_) {
    const Turn turn = virtual_turns(until, done);
    if (!real_) return turn;  // else time became real meanwhile
  }
  return real_turns(until, done);
}

HybridScheduler::Turn HybridScheduler::virtual_turns(Instant until, const std::function<bool()>& done) {
  for (;;) {
    settle();
    if (done()) return Turn::done;
    if (real_) return Turn::time;
    if (!has_alarms() && until == Instant::max()) return Turn::stuck;
    if (!has_alarms() || first_alarm() > until) break;
    virtual_now_ = std::max(virtual_now_, first_alarm());
    fire_due(virtual_now_);
  }
  virtual_now_ = std::max(virtual_now_, until);
  return Turn::time;
}

/// Runs ready work until an alarm is due. A device that sends without a pause would always leave more work.
void HybridScheduler::work_until_alarm(Instant until) {
  while (io().poll_one() > 0) {
    const Instant due = has_alarms() ? std::min(until, first_alarm()) : until;
    if (now() >= due) return;
  }
}

HybridScheduler::Turn HybridScheduler::real_turns(Instant until, const std::function<bool()>& done) {
  for (;;) {
    work_until_alarm(until);
    if (done()) return Turn::done;
    fire_due(now());
    if (done()) return Turn::done;
    if (now() >= until) return Turn::time;
    const Instant next = std::min(until, has_alarms() ? first_alarm() : Instant::max());
    if (next == Instant::max())
      io().run_one();
    else
      io().run_one_for(next - now());
  }
}

}  // namespace hw
