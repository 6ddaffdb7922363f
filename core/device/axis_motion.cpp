#include "core/device/axis_motion.h"

#include <fmt/core.h>

namespace hw {

void begin_motion(AxisState& axis, Activity activity, std::optional<Steps> target) {
  axis.activity = activity;
  axis.ended_by = EndedBy::nothing;
  axis.has_target = target.has_value();
  axis.target = target.value_or(Steps(0));
}

void stop_motion(AxisState& axis) {
  if (axis.moves()) axis.activity = Activity::stopping;
}

void end_motion(AxisState& axis, EndedBy why) {
  axis.activity = Activity::idle;
  axis.phase = Phase::unknown;
  axis.ended_by = why;
  axis.has_target = false;
  axis.direction = 0;
  axis.ramp = 0;
}

void lose_motion(AxisState& axis) {
  if (axis.moves()) axis.ended_by = EndedBy::lost;
  axis.activity = Activity::unknown;
  axis.phase = Phase::unknown;
  axis.direction = 0;
  axis.ramp = 0;
}

EndedBy ended_by_stop(EndedBy so_far, bool at_once) {
  return at_once || so_far == EndedBy::abort ? EndedBy::abort : EndedBy::stop;
}

StopProgress progress_of_stop(bool still_moves, Duration after) {
  constexpr Duration longest_stop = std::chrono::seconds(30);  // for a long ramp set by the user
  if (!still_moves) return StopProgress::stands();
  if (after <= longest_stop) return StopProgress::wait();
  return StopProgress::failed(Fault(FaultKind::controller, "Stop was sent, but the controller still moves.",
                                    "", "Stop again to stop it at once, without a ramp."));
}

std::string doubt_killed(AxisState& axis, const Kill& kill, Instant now) {
  if (kill.speed <= kill.safe) return {};
  axis.trust.doubt(Doubt::killed, now);
  return fmt::format(
      "{} may have lost steps: it was stopped without a ramp at {}{:.0f} {}, above {}. Its position cannot "
      "be trusted until it is {}.",
      kill.axis, kill.approx, kill.speed, kill.unit, kill.safe_word, kill.cure);
}

}  // namespace hw
