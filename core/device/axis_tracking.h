#pragma once
// What a driver knows of the motion of each axis: what it has begun and stopped, and what the status rounds
// show. For controllers that tell whether an axis moves; writes the axes of the snapshot.
#include <array>
#include <functional>
#include <optional>

#include "core/device/snapshot.h"
#include "core/device/stop.h"
#include "core/time/scheduler.h"

namespace hw {

struct Catalog;

class AxisTracking {
 public:
  AxisTracking(Snapshot& draft, const Scheduler& scheduler) : draft_(draft), scheduler_(scheduler) {}

  struct Motion {
    Activity activity = Activity::moving;
    std::optional<Steps> target = {};  ///< none: it runs until something ends it
    Sign sign = Sign::plus;            ///< where there is no target
    double ramp = 0;                   ///< steps/s²; 0: not known
  };
  /// One answer of the controller.
  struct Reading {
    Steps position{};
    bool moves = false;
    Pps speed{};
    bool limit_minus = false, limit_plus = false;
    bool homed = true;  ///< of a homing that is over: it has found its place
  };

  /// The controller has accepted a motion.
  void begun(int axis, const Motion& motion);
  /// A stop goes out; -1: for all axes.
  void stopping(int axis, bool at_once);
  /// A reading to a question that was asked at `asked_at`.
  void read(int axis, const Reading& reading, Instant asked_at);
  /// How far a stop of axes has come. Gives up after half a minute.
  [[nodiscard]] StopProgress progress(const StopOrder& order) const;
  /// The controller was switched off and on.
  void restarted();
  void wire_lost();

  /// Called with each axis that is stopped without a ramp, before it shows in the snapshot: from the present
  /// speed it may lose steps.
  std::function<bool(int axis)> may_lose_steps;

 private:
  struct Tracked {
    Activity wanted = Activity::idle;       ///< what the latest command began
    EndedBy stopped_by = EndedBy::nothing;  ///< a stop that was sent and not yet seen to have ended it
    Instant begun_at{}, asked_at{};         ///< latest command, and latest reading
    bool moves = false;                     ///< as last read
  };
  void show_moving(int axis);
  void show_ended(int axis, bool homed);

  Snapshot& draft_;
  const Scheduler& scheduler_;
  std::array<Tracked, max_axes> tracked_{};
};

/// The way that an axis still goes when it is stopped with its ramp, for Catalog::stopping_way: at most back
/// over the way that it has come, and no further than its target.
std::optional<double> stopping_way_by_ramp(const Catalog& catalog, const Snapshot& now, AxisId axis);

}  // namespace hw
