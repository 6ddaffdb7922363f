#pragma once
// What a driver knows of the motion of each axis: what it has begun and stopped, and what the status rounds
// show. For controllers that report whether an axis moves; writes the axes of the snapshot.
// The listed families keep their own: a VXM reports no motion at all, an Arcus judges status words beside
// StepNLoop, and on a VME58 motions wait in queues.
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
  /// A stop is sent; -1: for all axes. One without a ramp makes the count of a fast axis doubtful, and the
  /// user is told.
  void stopping(int axis, bool at_once);
  /// A reading to a question that was asked at `asked_at`.
  void read(int axis, const Reading& reading, Instant asked_at);
  /// How far a stop of axes has come. Gives up after half a minute.
  [[nodiscard]] StopProgress progress(const StopOrder& order) const;
  /// The user has set the count.
  void was_set(int axis) { context_.snapshot.axes[axis].trust.settle(Trust::set, context_.scheduler.now()); }
  /// The controller was switched off and on: counts it, makes set-up and positions doubtful, notifies the
  /// user.
  void restarted();
  /// Marks all as unknown.
  void wire_lost();

 private:
  struct Tracked {
    Activity wanted = Activity::idle;       ///< what the latest command began
    EndedBy stopped_by = EndedBy::nothing;  ///< a stop that was sent and not yet seen to have ended it
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
