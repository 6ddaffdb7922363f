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
  if (mind.stopping) return axis.speed;
  if (!axis.has_target) return at_once;
  if (axis.target != Steps(0)) return Pps{};
  return mind.top_speed.value > 0 ? std::max(axis.speed, mind.top_speed) : at_once;
}

ArcusDriver::Look ArcusDriver::begin_look() const {
  return {counters_.ask(), targets_.ask(), motors_.ask()};
}

ArcusDriver::Stood ArcusDriver::where_all_stand() const {
  Stood stood;
  stood.seen_at = scheduler_.now();
  stood.misses = talk_.misses();
  stood.program_ran = draft_.program.run == RunState::running;
  for (int i = 0; i < axis_count(); ++i)
    stood.axes[ix(i)] = {draft_.axes[i].position, draft_.axes[i].encoder, fastest_way_to_zero(i),
                         draft_.axes[i].in_counts ? Steps(loop_tolerance(i)) : Steps(0), moving(i)};
  return stood;
}

// Whatever is sent or heard goes through here before it is: a change that it explains is no power-cycle.
void ArcusDriver::may_set(std::string_view command) {
  if (may_set_counter(command)) counters_.may_be_set();
  if (may_set_target(command)) targets_.may_be_set();
  if (may_switch_motor(command)) motors_.may_be_set();
  if (command.starts_with("SR") && !ends_program(command)) program_runs();
  if (command.starts_with("GS")) program_runs(longest_run(command));
}

// After power-up every counter reads zero wherever the motors stand. Texts that may set a counter, homing and
// programs do that too, and a motion may end there; what puts a position where the encoder stands explains no
// more than that. Where the controller was silent in between, that is not
// taken for granted: look_at_motors() finds out. See also read_what_power_keeps(), for one that stood at
// zero.
void ArcusDriver::look_at_counters(const Look& look, bool was_silent) {
  if (talk_.misses() != motion_misses_ && !was_silent) return;  // some is of before, some of after, perhaps
  const bool unexplained = counters_.answered(look.counters);
  const bool targets_stay = targets_.answered(look.targets);
  const auto before = std::exchange(stood_, where_all_stand());
  if (!before || !unexplained) return;
  const bool silent = was_silent || stood_->misses != before->misses;
  const bool a_program_may = before->program_ran || stood_->program_ran;
  constexpr double between_two_looks = 1;  // s, and more where the wire was slow
  const double elapsed = between_two_looks + seconds(scheduler_.now() - before->seen_at);
  bool jumped = false, came_nearer = false, stands_at_zero = true;
  for (int i = 0; i < axis_count(); ++i) {
    const AxisState& axis = draft_.axes[i];
    const Stood::Axis& then = before->axes[ix(i)];
    stands_at_zero = stands_at_zero && !runs(i) && axis.position == Steps(0) && axis.encoder == Steps(0);
    std::int64_t way = std::abs(then.position.value) - then.room.value;
    if (!targets_stay) way = std::min(way, std::abs(then.encoder.value));
    const double reach = then.towards_zero.value > 0 ? then.towards_zero.value * elapsed : 0;
    came_nearer = came_nearer || way > std::abs(axis.position.value);
    jumped = jumped || static_cast<double>(way) > reach;
  }
  const bool a_program_did = was_silent && before->program_ran;
  if (came_nearer && ((silent && stands_at_zero) || a_program_did)) zero_in_doubt_ = before;
  if (stands_at_zero && jumped && !a_program_may)
    return restarted("All positions read zero, and nothing that was sent does that", before);
}

// The motors have power, or none, as after power-up (EOBOOT), and nobody has switched them. Power that is not
// as then shows that it was never cut.
Task<Result<>> ArcusDriver::look_at_motors(Unexplained::Mark asked) {
  std::int64_t on = 0;
  for (int i = 0; i < axis_count(); ++i) on |= std::int64_t{draft_.axes[i].enabled} << i;
  const bool a_program_may = programs_switch_motors() && (scheduler_.now() <= programs_run_until_ || called_);
  const bool unexplained = motors_.answered(asked) && !a_program_may;
  const auto before = std::exchange(motors_on_, on);
  const bool changed = before && *before != on && unexplained;
  if (!changed && !zero_in_doubt_) co_return Result<>();
  motors_on_ = before;                                     // until it is sure: the next round asks again
  auto again = co_await talk_.ask_number("EO", Priority::poll);  // a digit may have been garbled
  if (!again) co_return fail(again.error());
  if (*again != on) co_return Result<>();
  auto after_power_up = co_await talk_.ask_number("EOBOOT", Priority::poll);
  if (!after_power_up && after_power_up.error().kind != FaultKind::refused)
    co_return fail(after_power_up.error());
  motors_on_ = on;
  const bool as_after_power_up = after_power_up.value_or(0) == on;
  const auto in_doubt = std::exchange(zero_in_doubt_, std::nullopt);
  if (!as_after_power_up) co_return Result<>();
  if (changed) {
    restarted(fmt::format("Motor power {}, and nothing that was sent does that",
                          on < *before ? "went off" : "came on"),
              in_doubt);
    co_return Result<>();
  }
  auto may_be = co_await power_up_leads_here();
  if (!may_be) co_return fail(may_be.error());
  if (!*may_be) co_return Result<>();
  auto kept = co_await something_is_kept();
  if (!kept) co_return fail(kept.error());
  if (!*kept) restarted("It did not answer for a while, and then it counted from zero", in_doubt);
  co_return Result<>();
}

// After power-up all counters read zero, unless a program that it starts has moved since.
Task<Result<bool>> ArcusDriver::power_up_leads_here() {
  bool at_zero = true;
  for (int i = 0; i < axis_count(); ++i) at_zero = at_zero && draft_.axes[i].position == Steps(0);
  if (at_zero) co_return true;
  auto started = co_await talk_.ask_number("SLOAD", Priority::poll);
  if (!started && started.error().kind != FaultKind::refused) co_return fail(started.error());
  co_return started.value_or(0) != 0;
}

// A value that a power-cut would have taken back still stands; or it does not, and that has been told.
Task<Result<bool>> ArcusDriver::something_is_kept() {
  const int index = next_that_would_show();
  if (index < 0 || !nobody_sets_.test(ix(index))) co_return false;
  auto read = co_await read_param(index, Priority::poll);
  if (!read) co_return fail(read.error());
  co_return true;
}

// A program that nobody has started, and that power-up starts.
Task<Result<>> ArcusDriver::look_at_start(int thread, Priority priority) {
  auto starts_at_power_up = co_await talk_.ask_number("SLOAD", priority);
  if (!starts_at_power_up && starts_at_power_up.error().kind != FaultKind::refused)
    co_return fail(starts_at_power_up.error());
  if ((starts_at_power_up.value_or(0) >> thread & 1) != 0)
    restarted(fmt::format("Program {} runs, which power-up starts and nothing that was sent", thread),
              std::nullopt);
  co_return Result<>();
}

bool ArcusDriver::programs_switch_motors() const { return !stored_code_ || stored_code_->switches_motors; }

// A stop that nobody answered when the wire was lost explains no zero; motor power that was to be switched
// may have been.
Task<Result<>> ArcusDriver::look_back_over_the_loss() {
  if (stood_ && stood_->program_ran) program_runs();  // until a moment ago, perhaps
  counters_.settle();
  targets_.settle();
  look_at_counters(begin_look(), true);
  co_return co_await look_at_motors(motors_.ask());
}

// Where an answer was missing since the last look, whatever goes out next might hide a restart: an axis that
// moves does not stand at zero. What was asked for meant the controller as it was before.
Task<Result<>> ArcusDriver::look_after_silence() {
  if (!stood_ || stood_->misses == talk_.misses()) co_return Result<>();
  const std::uint32_t restarts = draft_.restarts;
  const Look look = begin_look();
  auto seen = co_await read_whole_motion(Priority::intent);
  if (seen) look_at_counters(look);
  if (seen && zero_in_doubt_) seen = co_await read_io(Priority::intent);
  if (seen && zero_in_doubt_) seen = co_await look_at_motors(look.motors);
  if (!seen && seen.error().kind == FaultKind::stopped) co_return seen;
  if (draft_.restarts == restarts) co_return Result<>();
  co_return fail(FaultKind::refused, "The controller was switched off and on, and stands otherwise now.",
                 "Nothing was sent.", "Look at its positions before you ask again.");
}

void ArcusDriver::restarted(std::string_view how_it_shows, const std::optional<Stood>& before) {
  ++draft_.restarts;
  for (ParamState& p : draft_.params) p = ParamState();
  for (ThreadState& t : draft_.threads) t = ThreadState();
  nobody_sets_.reset();
  unsaved_variables_ = draft_.unsaved_setup = false;
  draft_.variables_known.reset();
  draft_.readouts_known.reset();
  borrowed_.reset();
  stored_code_.reset();
  called_.reset();
  if (scheduler_.now() <= programs_run_until_) draft_.program.ended_by = EndedBy::lost;
  end_feed();
  stood_.reset();
  motors_on_.reset();
  zero_in_doubt_.reset();
  for (int i = 0; i < axis_count(); ++i) {
    if (before && before->axes[ix(i)].moved) draft_.axes[i].ended_by = EndedBy::lost;
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

void ArcusDriver::wire_lost() {
  if (!talk_.is_open()) return;
  talk_.wire_lost();
  lost_at_ = scheduler_.now();
  if (borrowed_) borrowed_->left_alone = true;
  end_feed();
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
