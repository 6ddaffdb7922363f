#include "core/devices/vxm/kills.h"

#include <fmt/core.h>

#include "core/device/axis_motion.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

Task<Result<>> Kills::kill(bool standing, Priority priority) {
  const bool something_ran = under_way_.busy() || presence_.is_halted();
  auto reply = co_await conversation_.kill(priority, kill_patience);
  if (!reply && reply.error().kind == FaultKind::stopped) co_return fail(reply.error());  // it was not sent
  under_way_.kill_was_sent();
  if (!standing) doubt_positions();
  const EndedBy ended_by = standing ? EndedBy::stop : EndedBy::abort;
  if (!reply) {
    under_way_.kill_not_confirmed(ended_by);
    if (reply.error().kind == FaultKind::lost) co_return fail(reply.error());
    co_return fail(FaultKind::no_answer,
                   "K was sent to stop everything, but the controller did not confirm it.",
                   "Nothing else was sent.", "Watch the motors. If one still turns, use the power switch.");
  }
  under_way_.killed(ended_by);
  if (something_ran && console_.snapshot.outputs_known && console_.snapshot.outputs)
    console_.report(Notice::Kind::info, "K ended the run and switched the outputs off.");
  headline_.show();
  if (console_.changed) console_.changed();
  co_return Result<>();
}

// K above 1000 steps/s may lose steps unnoticed by the controller (p.23). An unknown speed counts as fast,
// and a motion under way when the wire was lost as still turning.
void Kills::doubt_positions() const {
  const bool program_runs = under_way_.program_runs();
  for (int i = 0; i < console_.snapshot.axis_count; ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    const bool hidden = program_runs && i >= motors_per_controller && identification_.has_slave();
    const bool unseen = axis.activity == Activity::unknown && under_way_.was_lost_while_busy() &&
                        (program_runs || under_way_.job().moves(i));
    if ((!axis.moves() && !hidden && !unseen) || axis.trust.doubtful()) continue;
    const double set_speed = axis.speed.value;
    const double speed = set_speed > 0             ? set_speed
                         : program_runs && !hidden ? readings_.speed(i)
                                                   : default_speed;
    const Kill kill{.axis = fmt::format("Motor {}", i + 1),
                    .speed = speed,
                    .safe = hard_stop_safe_speed,
                    .unit = "steps/s",
                    .approx = "about ",
                    .safe_word = fmt::format("{}", hard_stop_safe_speed),
                    .cure = "homed or set to zero"};
    std::string doubt = doubt_killed(axis, kill, console_.scheduler.now());
    if (!doubt.empty()) console_.report(Notice::Kind::warning, std::move(doubt));
  }
}

}  // namespace hw::vxm
