#pragma once
// The state word of an axis and of a whole controller. One place, so that digits, tabs and lamps agree.
#include <cstdint>

#include "core/device/snapshot.h"

namespace hw::gui {

enum class State : std::uint8_t {
  idle,
  moving_plus,
  moving_minus,
  moving,  ///< several axes, or direction unknown
  homing_plus,
  homing_minus,
  stopping,
  limit_plus,
  limit_minus,
  off,
  stale,
  untrusted,
  lost,
  fault,
  waiting,
  connecting,
  slipped,      ///< at rest; its encoder was too far off
  in_place,     ///< servo axis: its encoder is at the target
  open_loop,    ///< servo axis: its motor is free
  not_in_place  ///< servo axis: it has not reached its target
};

/// Missing knowledge takes precedence: an axis that cannot be seen is not called idle.
State state_of(const Snapshot& now, int axis, Instant clock);
/// The axis stays in place in a move of several axes: the controller reports it running, at no speed.
bool only_goes_along(const AxisState& axis);
/// The worst state of all axes and the link; `moving` when several move.
State worst_state(const Snapshot& now, Instant clock);
bool is_motion(State state);
/// A fault or warning that motion hides from worst_state(): a position that cannot be trusted, a slip, a
/// servo axis off its place, a limit, a notice.
bool needs_attention(const Snapshot& now);
/// From harmless to bad.
int badness(State state);
/// The position is older than three poll periods.
bool is_old(const Snapshot& now, int axis, Instant clock);

}  // namespace hw::gui
