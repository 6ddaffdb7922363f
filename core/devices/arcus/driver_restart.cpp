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
  const AxisState& axis = draft_.axes[index];
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
        const Steps room = draft_.axes[axis].in_counts ? Steps(loop_tolerance(axis)) : Steps(0);
        const bool to_encoder = minds_[ix(axis)].stopping && draft_.axes[axis].in_counts;
        return RestartWatch::AxisNow{runs(axis), moving(axis), to_encoder, fastest_way_to_zero(axis), room};
      },
      [this](std::string_view how_it_shows, unsigned moved) { restarted(how_it_shows, moved); },
      [this] { may_have_restarted(); }};
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
  const std::uint32_t restarts = draft_.restarts;
  const RestartWatch::Look look = watch_.begin_look();
  auto seen = co_await read_motion(Priority::intent);
  if (seen && watch_.in_doubt()) seen = co_await read_io(Priority::intent);
  if (seen && watch_.in_doubt()) seen = co_await watch_.look_at_motors(look);
  if (seen && draft_.restarts == restarts) co_return seen;
  if (!seen && worth_another_try(seen.error())) {
    seen.error().kind = FaultKind::refused;
    seen.error().done = "Nothing was sent.";
  }
  if (!seen) co_return seen;
  co_return fail(FaultKind::refused, "The controller was switched off and on, and stands otherwise now.",
                 "Nothing was sent.", "Look at its positions before you ask again.");
}

void ArcusDriver::restarted(std::string_view how_it_shows, unsigned moved) {
  ++draft_.restarts;
  setup_.restarted();
  for (ThreadState& t : draft_.threads) t = ThreadState();
  draft_.variables_known.reset();
  draft_.readouts_known.reset();
  borrowed_.forget();
  code_.restarted();
  if (code_.program_may_run()) draft_.program.ended_by = EndedBy::lost;
  list_.end();
  watch_.forget();
  for (int i = 0; i < axis_count(); ++i) {
    if ((moved >> i & 1u) != 0) draft_.axes[i].ended_by = EndedBy::lost;
    minds_[static_cast<std::size_t>(i)] = AxisMind();
    draft_.axes[i].has_target = false;
    draft_.axes[i].trust.doubt(Doubt::power_cut, scheduler_.now());
  }
  tell(Notice::Kind::warning,
       fmt::format(
           "{}: the controller was switched off and on, or another program did it. What was not stored is "
           "gone; it is read afresh. Find home before the next absolute move.",
           how_it_shows));
}

void ArcusDriver::may_have_restarted() {
  for (int i = 0; i < axis_count(); ++i)
    if (draft_.axes[i].position == Steps(0)) draft_.axes[i].trust.doubt(Doubt::unheard, scheduler_.now());
  tell(Notice::Kind::warning,
       "Answers were missing, and then all positions read zero: what was sent has done that, or the "
       "controller was switched off and on. Look where the axes stand, and find home before the next "
       "absolute move.");
}

void ArcusDriver::wire_lost() {
  if (!talk_.is_open()) return;
  talk_.wire_lost();
  lost_at_ = scheduler_.now();
  borrowed_.leave_alone();
  list_.end();
  draft_.transfer = TransferState();
  for (int i = 0; i < axis_count(); ++i) {
    AxisState& axis = draft_.axes[i];
    if (moving(i)) axis.ended_by = EndedBy::lost;
    minds_[static_cast<std::size_t>(i)].stopping = false;
    axis.activity = Activity::unknown;
    axis.phase = Phase::unknown;
    axis.position_known = false;
    axis.limits_known = false;
    axis.direction = 0;
    axis.speed = axis.own_speed = Pps{};
  }
  for (ThreadState& t : draft_.threads) t.known = false;  // those that ran are stopped first
  draft_.inputs_known = draft_.outputs_known = draft_.analog_known = 0;
  draft_.readouts_known.reset();
  draft_.variables_known.reset();
}

}  // namespace hw::arcus
