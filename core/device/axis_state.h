#pragma once
// The state of one axis, as its driver knows it: a part of the snapshot.
#include <cstdint>

#include "core/base/units.h"
#include "core/device/backlash.h"
#include "core/device/travel.h"
#include "core/device/trust.h"
#include "core/time/clock.h"

namespace hw {

enum class Activity : std::uint8_t { unknown, idle, moving, jogging, homing, stopping, error };

/// How the latest motion of an axis, or the latest run of a program, ended.
enum class EndedBy : std::uint8_t {
  nothing,
  target,
  limit,
  stop,       ///< by the console, with the ramp
  abort,      ///< by the console, without a ramp
  elsewhere,  ///< cut short by a program in the controller, at its Stop input, or by another host
  error,
  lost,
  not_in_place  ///< servo axis: the command has ended, and the encoder did not reach the target
};
/// The part of its profile that a motion is in, if the controller reports it.
enum class Phase : std::uint8_t { unknown, accelerating, constant, decelerating };

/// The cause of Activity::error until it is cleared, if the controller reports it.
enum class AxisError : std::uint8_t {
  none,
  limit_minus,
  limit_plus,
  limit,  ///< one of the two; the controller does not report which
  alarm,
  stalled,
  too_far,       ///< closed loop: the position error is larger than allowed
  not_corrected  ///< closed loop: given up after the allowed number of attempts
};

/// How a servo axis (AxisInfo::servo) follows its command.
enum class Loop : std::uint8_t {
  none,       ///< not a servo axis: its position is what the controller counts
  unknown,    ///< not known yet whether its loop is closed
  open,       ///< the motor is free: nothing holds it at its command
  following,  ///< the axis follows its command, or settles
  in_place,   ///< the position error has been within the deadband for a while
  off_place   ///< the command ended some time ago, and the axis has not arrived
};

struct AxisState {
  Steps position{};             ///< servo axis: of the encoder
  Instant seen_at{};            ///< when the position was read
  bool position_known = false;  ///< false: never read, or no longer valid since a loss or reset
  PositionTrust trust;          ///< of `position`
  Travel travel;                ///< set by the user; see travel_holds()
  Backlash backlash;            ///< set by the user
  Activity activity = Activity::unknown;
  Phase phase = Phase::unknown;
  AxisError error = AxisError::none;
  EndedBy ended_by = EndedBy::nothing;
  std::int8_t direction = 0;  ///< -1, 0, +1 of the present motion
  Pps speed{};                ///< of the present motion, reported or commanded; 0: unknown or at rest
  double ramp = 0;   ///< steps/s²: acceleration and deceleration of the present motion; 0: not known
  Steps began_at{};  ///< where the present motion began, while its ramp is known
  Pps own_speed{};   ///< steps/s of a motion that names no speed (intent::JogStart); 0: not known yet
  bool has_target = false;
  Steps target{};
  bool in_counts = false;  ///< closed loop: position, speed and target count in Catalog::loop_word
  bool has_encoder = false;
  Steps encoder{};
  Loop loop = Loop::none;
  Steps command{};  ///< servo axis: the commanded position at this instant
  bool far_off =
      false;  ///< the position error is so large that closing the loop needs an answer: intent::Closing
  bool limit_minus = false, limit_plus = false, home = false, alarm = false;
  bool limits_known = false;
  bool enabled = true;   ///< motor current; see AxisInfo::switchable
  bool slipped = false;  ///< the encoder was further off than allowed, and the flag has not been cleared
  bool operator==(const AxisState&) const = default;

  [[nodiscard]] bool moves() const {
    return activity == Activity::moving || activity == Activity::jogging || activity == Activity::homing ||
           activity == Activity::stopping;
  }
  /// Where a move begins, and the base of a relative one.
  [[nodiscard]] Steps commanded() const { return loop == Loop::none ? position : command; }
  /// The limits apply. They do not while the count is doubtful: the check would be worthless.
  [[nodiscard]] bool travel_holds() const {
    return travel.any() && position_known && !trust.doubtful() && travel.in_counts == in_counts;
  }
  /// The present target; at rest, the position.
  [[nodiscard]] Steps goal() const { return has_target ? target : commanded(); }
  [[nodiscard]] Steps following_error() const { return commanded() - position; }
};

}  // namespace hw
