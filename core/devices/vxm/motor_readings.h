#pragma once
// Which motors turn, and how fast, as far as successive readings show.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/index.h"
#include "core/base/units.h"
#include "core/device/snapshot.h"
#include "core/devices/vxm/facts.h"
#include "core/time/scheduler.h"

namespace hw::vxm {

/// Positions unchanged for this time show a standstill.
inline constexpr Duration to_see_standstill = Millis(60);

class MotorReadings {
 public:
  struct Change {
    bool moved = false;
    bool begun = false;     ///< from a standstill
    bool reversed = false;  ///< the motor turned the other way before
    Instant since{};        ///< when the previous reading was asked for: the change came later
  };

  explicit MotorReadings(const Scheduler& scheduler) : scheduler_(scheduler) {}

  /// `at`: when the reading was asked for. `before`: shown until now.
  Change take(int motor, const AxisState& before, Steps position, Instant at) {
    Seen& seen = seen_[ix(motor)];
    const double way = static_cast<double>((position - before.position).value);
    if (before.position_known && at > before.seen_at)
      seen.speed = std::abs(way) / seconds(at - before.seen_at);
    Change change;
    change.since = std::exchange(seen.read_at, at);
    change.moved = before.position_known && before.position != position;
    const Sign sign = way > 0 ? Sign::plus : Sign::minus;
    // The last step of a slow ramp may come as late as the first of another motion: the next step decides.
    const bool stood = at - seen.moved_at >= to_see_standstill;
    const bool one_more = std::abs(way) <= 1 && seen.went == sign;
    change.begun = change.moved && (stood ? !one_more : seen.crept);
    if (change.moved) seen.crept = stood && one_more;
    change.reversed = change.moved && seen.went && seen.went != sign;
    if (change.moved) seen.went = sign;
    if (change.moved || !before.position_known)
      seen.moved_at = at;  // after a single reading, the motor may be turning
    return change;
  }
  /// A stored program begins: earlier motions were not its own.
  void forget_directions() {
    for (Seen& seen : seen_) seen.went.reset();
  }

  [[nodiscard]] Instant moved_at(int motor) const { return seen_[ix(motor)].moved_at; }
  [[nodiscard]] bool has_turned_within(Duration time, int motor) const {
    return scheduler_.now() - moved_at(motor) < time;
  }
  /// Whether the motor has been read and has not moved for `to_see_standstill` since `then`.
  [[nodiscard]] bool has_stood_since(Instant then, int motor) const {
    const Seen& seen = seen_[ix(motor)];
    return seen.read_at - std::max(seen.moved_at, then) >= to_see_standstill;
  }
  /// Last direction since forget_directions(); none: no motion.
  [[nodiscard]] std::optional<Sign> went(int motor) const { return seen_[ix(motor)].went; }
  /// Steps/s between the last two readings.
  [[nodiscard]] double speed(int motor) const { return seen_[ix(motor)].speed; }
  /// Steps/s, of the motors that can be read while they turn.
  [[nodiscard]] double fastest() const { return std::max(speed(0), speed(1)); }

 private:
  struct Seen {
    Instant read_at{}, moved_at{};
    std::optional<Sign> went;
    double speed = 0;
    bool crept = false;  ///< moved a single step after a standstill
  };
  const Scheduler& scheduler_;
  std::array<Seen, max_motors> seen_{};
};

}  // namespace hw::vxm
