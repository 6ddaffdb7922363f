#pragma once
// Which state word an axis and a whole controller deserve. One place, so that digits, tabs and lamps agree.
#include <cstdint>

#include "core/device/snapshot.h"

namespace hw::gui {

enum class State : std::uint8_t {
  idle,
  moving_plus,
  moving_minus,
  moving,  ///< several axes, or the direction is not known
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
  slipped,      ///< stands, and its encoder has lain too far off
  in_place,     ///< a servo axis: its encoder stands where it is sent
  open_loop,    ///< a servo axis: its motor is free
  not_in_place  ///< a servo axis: it has not come where it was sent
};

/// What is not known comes first: an axis that cannot be seen is not called idle.
State state_of(const Snapshot& now, int axis, Instant clock);
/// The worst state of all axes and the link; `moving` when several move.
State worst_state(const Snapshot& now, Instant clock);
bool is_motion(State state);
/// From harmless to bad.
int badness(State state);
/// The position is older than three poll periods.
bool is_old(const Snapshot& now, int axis, Instant clock);

}  // namespace hw::gui
