// Noticing that the controller was switched off and on, and what is left of it then, or behind a lost wire.

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {

RestartWatch::Ways ArcusDriver::ways_of_watch() {
  return {[this](int axis) { return motions_.now(axis); },
          [this](std::string_view how_it_shows, unsigned moved) { restarted(how_it_shows, moved); }};
}

// Whatever is sent or heard goes through here before it is.
void ArcusDriver::may_set(std::string_view command) {
  watch_.goes_out(command);
  threads_.may_start(command);
}

// A stop that nobody answered when the wire was lost explains no zero; motor power that was to be switched
// may have been.
Task<Result<>> ArcusDriver::look_back_over_the_loss() {
  if (watch_.program_ran()) threads_.program_runs();  // until a moment ago, perhaps
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
  auto seen = co_await status_.read(Priority::intent);
  if (seen && watch_.in_doubt()) seen = co_await lines_.read(Priority::intent);
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
  motions_.restarted(moved);
  console_.tell(
      Notice::Kind::warning,
      fmt::format(
          "{}: the controller was switched off and on, or another program did it. What was not stored is "
          "gone; it is read afresh. Find home before the next absolute move.",
          how_it_shows));
}

std::string ArcusDriver::leaves_behind() const {
  const std::string left = stored_.leaves_behind(), borrowed = borrowed_.leaves_behind();
  return left.empty() || borrowed.empty() ? left + borrowed : left + ' ' + borrowed;
}

void ArcusDriver::wire_lost() {
  if (!talk_.is_open()) return;
  talk_.wire_lost();
  lost_at_ = console_.scheduler.now();
  borrowed_.leave_alone();
  list_.end();
  motions_.wire_lost();
  console_.draft.transfer = TransferState();
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.draft.axes[i];
    if (console_.draft.axis_moves(i)) axis.ended_by = EndedBy::lost;
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
