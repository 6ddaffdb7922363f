#pragma once
// Tracks the motion of each axis for a driver: the motions that it has begun and stopped, and the readings of
// the status rounds. For controllers that report whether an axis moves. Writes the axes of the snapshot. The
// listed families decide for themselves whether an axis moves: a VXM reports no motion, an Arcus combines
// status words with StepNLoop, and on a VME58 motions wait in queues. The consequences are the same for all
// (axis_motion.h).
#include <array>
#include <optional>

#include "core/device/driver.h"

namespace hw {

class AxisTracking {
 public:
  /// Up to `start_speed` a motor starts and stops without a ramp. The context must outlive it.
  AxisTracking(DriverContext& context, Pps start_speed) : context_(context), start_speed_(start_speed) {}

  struct Motion {
    Activity activity = Activity::moving;
    std::optional<Steps> target = {};  ///< none: the motion continues until something ends it
    Sign sign = Sign::plus;            ///< the direction, if there is no target
    double ramp = 0;                   ///< steps/s²; 0: not known
  };
  /// One answer of the controller.
  struct Reading {
    Steps position{};
    bool moves = false;
    Pps speed{};
    bool limit_minus = false, limit_plus = false;
    bool homed = true;  ///< of a homing that is over: home was found
  };

  /// The controller has accepted a motion.
  void begun(int axis, const Motion& motion);
  /// A stop is sent; -1: for all axes. A stop without a ramp makes the count of a fast axis doubtful, and the
  /// user is warned.
  void stopping(int axis, bool at_once);
  /// A reading to a question that was asked at `asked_at`.
  void read(int axis, const Reading& reading, Instant asked_at);
  /// The progress of a stop of axes. Gives up after half a minute.
  [[nodiscard]] StopProgress progress(const StopOrder& order) const;
  /// The user has set the count.
  void was_set(int axis) { context_.snapshot.axes[axis].trust.settle(Trust::set, context_.scheduler.now()); }
  /// The controller was switched off and on: counts it, makes set-up and positions doubtful, notifies the
  /// user.
  void restarted();
  /// Marks all axes as unknown.
  void wire_lost();

 private:
  struct Tracked {
    Activity wanted = Activity::idle;       ///< the activity that the latest command began
    EndedBy stopped_by = EndedBy::nothing;  ///< a stop that was sent and whose effect has not been seen yet
    Instant begun_at{}, asked_at{};         ///< latest command, and latest reading
    bool moves = false;                     ///< as last read
  };
  void show_moving(int axis);
  void show_ended(int axis, bool homed);

  void may_lose_steps(int axis);
  void warn(std::string sentence);

  DriverContext& context_;
  const Pps start_speed_;
  std::array<Tracked, max_axes> tracked_{};
};

}  // namespace hw
