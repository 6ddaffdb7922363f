#pragma once
// The steps that the motion of an axis takes in the snapshot, the same for every controller. Its driver
// decides from its readings when a motion begins and why it has ended (AxisTracking does so for controllers
// that report whether an axis moves), and takes these steps.
#include <optional>
#include <string>
#include <string_view>

#include "core/device/axis_state.h"
#include "core/device/stop.h"

namespace hw {

/// The controller has accepted a motion: the end of the last one no longer counts. No target: none is known.
void begin_motion(AxisState& axis, Activity activity, std::optional<Steps> target = {});
/// A stop that moves an axis is sent.
void stop_motion(AxisState& axis);
/// It rests.
void end_motion(AxisState& axis, EndedBy why);
/// The controller has restarted, or is out of reach: nobody sees how a motion ends.
void lose_motion(AxisState& axis);

/// How a motion will have ended: a stop at once is not taken back by one with the ramp that follows.
EndedBy ended_by_stop(EndedBy so_far, bool at_once);

/// Whether a stop is over, `after` it was sent. One that lasts half a minute has failed.
StopProgress progress_of_stop(bool still_moves, Duration after);

/// A motor that was stopped without a ramp.
struct Kill {
  std::string axis;              ///< "Axis X"
  double speed = 0, safe = 0;    ///< its speed, and the one up to which it stops in step
  std::string_view unit = {};    ///< "steps/s"
  std::string_view approx = {};  ///< "about ": the speed is not read
  std::string safe_word = {};    ///< "1000", "its low speed, 100"
  std::string_view cure = "homed or set";
};
/// Faster than that it overshoots: its position becomes doubtful. The sentence to report; empty: it stopped
/// in step.
std::string doubt_killed(AxisState& axis, const Kill& kill, Instant now);

}  // namespace hw
