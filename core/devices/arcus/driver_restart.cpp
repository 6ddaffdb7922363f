// Noticing that the controller was switched off and on, and what is left of it then, or behind a lost wire.
#include <algorithm>
#include <cstdlib>
#include <limits>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {

// How fast a counter may come to zero by itself. An axis on its way elsewhere, or away from there, does not
// rest at zero.
Pps ArcusDriver::fastest_way_to_zero(int index) const {
  constexpr Pps at_once{std::numeric_limits<double>::infinity()};
  const AxisState& axis = console_.draft.axes[index];
  const AxisMind& mind = minds_[ix(index)];
  if (!moving(index)) return Pps{};
  if (!mind.ours || mind.wanted == Activity::homing) return at_once;
  const bool away = axis.position.value * axis.direction > 0;
  if (mind.wanted == Activity::jogging) return away ? Pps{} : std::max(axis.speed, mind.top_speed);
  if (mind.stopping) return away ? Pps{} : axis.speed;
  if (!axis.has_target) return at_once;
  if (axis.target != Steps(0)) return Pps{};
  return mind.top_speed.value > 0 ? std::max(axis.speed, mind.top_speed) : at_once;
}

RestartWatch::Ways ArcusDriver::ways_of_watch() {
  return {
      [this](int axis) {
        const Steps room = console_.draft.axes[axis].in_counts ? Steps(loop_tolerance(axis)) : Steps(0);
        const bool to_encoder = minds_[ix(axis)].stopping && console_.draft.axes[axis].in_counts;
        return RestartWatch::AxisNow{runs(axis), moving(axis), to_encoder, fastest_way_to_zero(axis), room};
      },
      [this](std::string_view how_it_shows, unsigned moved) { restarted(how_it_shows, moved); }};
}

// Whatever is sent or heard goes through here before it is.
void ArcusDriver::may_set(std::string_view command) {
  watch_.goes_out(command);
  if (command.starts_with("SR") && !ends_program(command)) program_runs();
  if (command.starts_with("GS")) program_runs(code_.longest_run(command));
}

// A stop that nobody answered when the wire was lost explains no zero; motor power that was to be switched
// may have been.
Task<Result<>> ArcusDriver::look_back_over_the_loss() {
  if (watch_.program_ran()) program_runs();  // until a moment ago, perhaps
  watch_.settle();
  const RestartWatch::Look look = watch_.begin_look();
  watch_.look_at_counters(look, true);
  co_return co_await watch_.look_at_motors(look);
}

// Where an answer was missing since the last look, whatever goes out next might hide a restart: an axis that
// moves does not stand at zero. What was asked for meant the controller as it was before.
Task<Result<>> ArcusDriver::look_after_silence() {
  if (!watch_.was_silent() && !watch_.in_doubt()) co_return Result<>();
  const std::uint32_t restarts = console_.draft.restarts;
  const RestartWatch::Look look = watch_.begin_look();
  auto seen = co_await read_motion(Priority::intent);
  if (seen && watch_.in_doubt()) seen = co_await read_io(Priority::intent);
  if (seen && watch_.in_doubt()) seen = co_await watch_.look_at_motors(look);
  if (seen && console_.draft.restarts == restarts) co_return seen;
  if (!seen && worth_another_try(seen.error())) {
    seen.error().kind = FaultKind::refused;
    seen.error().done = "Nothing was sent.";
  }
  if (!seen) co_return seen;
  co_return fail(FaultKind::refused, "The controller was switched off and on, and stands otherwise now.",
                 "Nothing was sent.", "Look at its positions before you ask again.");
}

void ArcusDriver::restarted(std::string_view how_it_shows, unsigned moved) {
  ++console_.draft.restarts;
  setup_.restarted();
  for (ThreadState& t : console_.draft.threads) t = ThreadState();
  console_.draft.variables_known.reset();
  console_.draft.readouts_known.reset();
  borrowed_.forget();
  code_.restarted();
  if (code_.program_may_run()) console_.draft.program.ended_by = EndedBy::lost;
  list_.end();
  watch_.forget();
  for (int i = 0; i < console_.axes(); ++i) {
    if ((moved >> i & 1u) != 0) console_.draft.axes[i].ended_by = EndedBy::lost;
    minds_[static_cast<std::size_t>(i)] = AxisMind();
    console_.draft.axes[i].has_target = false;
    console_.draft.axes[i].trust.doubt(Doubt::power_cut, console_.scheduler.now());
  }
  console_.tell(
      Notice::Kind::warning,
      fmt::format(
          "{}: the controller was switched off and on, or another program did it. What was not stored is "
          "gone; it is read afresh. Find home before the next absolute move.",
          how_it_shows));
}

void ArcusDriver::wire_lost() {
  if (!talk_.is_open()) return;
  talk_.wire_lost();
  lost_at_ = console_.scheduler.now();
  borrowed_.leave_alone();
  list_.end();
  console_.draft.transfer = TransferState();
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.draft.axes[i];
    if (moving(i)) axis.ended_by = EndedBy::lost;
    minds_[static_cast<std::size_t>(i)].stopping = false;
    axis.activity = Activity::unknown;
    axis.phase = Phase::unknown;
    axis.position_known = false;
    axis.limits_known = false;
    axis.direction = 0;
    axis.speed = axis.own_speed = Pps{};
  }
  for (ThreadState& t : console_.draft.threads) t.known = false;  // those that ran are stopped first
  console_.draft.inputs_known = console_.draft.outputs_known = console_.draft.analog_known = 0;
  console_.draft.readouts_known.reset();
  console_.draft.variables_known.reset();
}

}  // namespace hw::arcus
