#pragma once
// Time as the whole program counts it: nanoseconds since the scheduler's start, real or virtual.
#include <chrono>
#include <cstdint>

namespace hw {

using Duration = std::chrono::nanoseconds;

struct SchedulerClock {  // names the time base; a Scheduler has the now()
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<SchedulerClock, duration>;
};
using Instant = SchedulerClock::time_point;

using Millis = std::chrono::milliseconds;

constexpr double seconds(Duration d) { return std::chrono::duration<double>(d).count(); }
constexpr double seconds(Instant t) { return seconds(t.time_since_epoch()); }
constexpr Duration from_seconds(double s) {
  return Duration(static_cast<Duration::rep>(s * 1e9 + (s < 0 ? -0.5 : 0.5)));
}

}  // namespace hw
