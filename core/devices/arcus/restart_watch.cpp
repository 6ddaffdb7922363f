#include "core/devices/arcus/restart_watch.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {

unsigned RestartWatch::Reference::moved() const {
  unsigned bits = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) bits |= axes[i].then.moving ? 1u << i : 0u;
  return bits;
}

RestartWatch::Reference RestartWatch::reference_of_now() const {
  Reference stood;
  stood.seen_at = console_.scheduler.now();
  stood.misses = conversation_.misses();
  stood.program_ran = console_.snapshot.program.run == RunState::running;
  for (int i = 0; i < console_.snapshot.axis_count; ++i) {
    const AxisNow now = callbacks_.axis_now(i);
    stood.axes[ix(i)] = {console_.snapshot.axes[i].position, console_.snapshot.axes[i].encoder, now,
                         now.leaves_zero, false};
  }
  return stood;
}

void RestartWatch::goes_out(std::string_view command) {
  if (may_set_counter(command)) counters_.may_be_set();
  if (may_set_target(command)) targets_.may_be_set();
  if (may_switch_motor(command)) motors_.may_be_set();
  if (!reference_) return;
  const bool stops = ends_motion(command), moves = may_move(console_.forms, command);
  for (Reference::Axis& axis : reference_->axes)
    if (moves || (stops && std::exchange(axis.sent_from_zero, false))) axis.may_have_left = true;
}

// No reading shows the motion yet. Before the next reading the power may fail, or the axis may arrive.
void RestartWatch::was_sent_to(int axis, Steps target) {
  if (!reference_) return;
  Reference::Axis& stood = reference_->axes[ix(axis)];
  stood.sent_from_zero = target != Steps(0);
  stood.then.towards_zero = std::max(stood.then.towards_zero, callbacks_.axis_now(axis).towards_zero);
}
void RestartWatch::jogs(int axis, Sign way) {
  if (reference_ && reference_->axes[ix(axis)].position.value * factor(way) >= 0)
    reference_->axes[ix(axis)].sent_from_zero = true;
}
void RestartWatch::position_was_set(int axis, Steps position) {
  if (reference_) reference_->axes[ix(axis)].position = position;
}
void RestartWatch::encoder_was_set(int axis, Steps position) {
  if (reference_) reference_->axes[ix(axis)].encoder = position;
}

void RestartWatch::forget() {
  reference_.reset();
  motors_on_.reset();
  be_in_doubt(std::nullopt);
}

// After power-up every counter reads zero wherever the motors stand. Texts that may set a counter, homing and
// programs cause that too, and a motion may end there; a command that sets a position to the encoder's
// explains no more than that. If the controller was silent in between, no explanation counts:
// look_at_motors() decides. See also SetUp::read_next_volatile(), for a controller that stood at zero.
void RestartWatch::look_at_counters(const Look& look, bool was_silent) {
  if (!motion_is_whole() && !was_silent) return;  // readings may be from before and after a restart
  const bool unexplained = counters_.answered(look.counters);
  const bool targets_stay = targets_.answered(look.targets);
  const auto before = std::exchange(reference_, reference_of_now());
  if (!before) return;
  const bool silent = was_silent || reference_->misses != before->misses;
  const bool a_program_may = before->program_ran || reference_->program_ran;
  constexpr double between_two_looks = 1;  // s, and more where the wire was slow
  const double elapsed = between_two_looks + seconds(console_.scheduler.now() - before->seen_at);
  Change all;
  bool stands_at_zero = true, others_at_zero = true,
       others_came_there = false;  // other axes than those sent away from zero
  for (int i = 0; i < console_.snapshot.axis_count; ++i) {
    const AxisState& axis = console_.snapshot.axes[i];
    const bool at_zero =
        !reference_->axes[ix(i)].then.runs && axis.position == Steps(0) && axis.encoder == Steps(0);
    const Change change = change_of(axis, before->axes[ix(i)], elapsed, targets_stay);
    const bool sent_from_zero = before->axes[ix(i)].sent_from_zero;
    stands_at_zero = stands_at_zero && at_zero;
    others_at_zero = others_at_zero && (at_zero || sent_from_zero);
    others_came_there = others_came_there || (!sent_from_zero && change.nearer);
    all.add(change);
  }
  // A program that reached zero and its end, all unseen, is less likely than a restart.
  all.nearer = all.nearer || (all.may_be_nearer && before->program_ran);
  const bool a_program_did = was_silent && before->program_ran;
  const bool unseen_at_zero = silent && stands_at_zero;
  const bool came_there = (all.nearer || all.may_be_nearer) && (unseen_at_zero || a_program_did);
  const bool others_did = silent && others_at_zero && others_came_there;
  if (came_there || others_did || (unseen_at_zero && before->program_ran))
    be_in_doubt(InDoubt{*before, stands_at_zero || others_did, !unexplained || !all.nearer});
  if (unexplained && stands_at_zero && all.jumped && !a_program_may)
    return callbacks_.restarted("All positions read zero, although no command set them", before->moved());
}

RestartWatch::Change RestartWatch::change_of(const AxisState& now, const Reference::Axis& before,
                                             double elapsed_s, bool targets_stay) {
  const std::int64_t stood = std::abs(before.position.value), left = stood - before.then.room.value;
  const std::int64_t encoder = std::abs(before.encoder.value), here = std::abs(now.position.value);
  const bool unmoved = now.error == AxisError::none;  // and neither a switch nor its loop has kept it there
  const bool never_left = before.sent_from_zero && unmoved && !now.in_counts;
  const bool nearer = (before.then.moving ? left : stood) > here;
  const bool by_encoder = !targets_stay || before.then.to_encoder;
  const std::int64_t way = by_encoder ? std::min(left, encoder) : left;
  const double speed = before.then.towards_zero.value, reach = speed > 0 ? speed * elapsed_s : 0;
  const bool by_itself = speed > 0 && static_cast<double>(way) <= reach;
  Change change;
  change.nearer = never_left || (nearer && !by_itself && (!by_encoder || encoder > here));
  // The load of an axis that follows its encoder may be jammed.
  change.may_be_nearer = nearer || ((before.sent_from_zero || before.may_have_left) && unmoved);
  change.jumped = static_cast<double>(way) > reach;
  return change;
}

// Motor power has become as after power-up (EOBOOT), and no command switched it: a restart. Motor power that
// differs from EOBOOT shows that the supply was never cut.
Task<Result<>> RestartWatch::look_at_motors(const Look& look) {
  std::int64_t on = 0;
  for (int i = 0; i < console_.snapshot.axis_count; ++i)
    on |= std::int64_t{console_.snapshot.axes[i].enabled} << i;
  const bool a_program_may = code_.switches_motors() && (code_.program_may_run() || code_.was_called());
  const bool unexplained = motors_.answered(look.motors) && !a_program_may;
  const auto before = std::exchange(motors_on_, on);
  const bool changed = before && *before != on && unexplained;
  if (!changed && !zero_in_doubt_) co_return Result<>();
  motors_on_ = before;  // until it is sure: the next round asks again
  auto again = co_await conversation_.ask_number("EO", Priority::poll);  // a digit may have been garbled
  if (!again) co_return fail(again.error());
  if (*again != on) co_return Result<>();
  auto after_power_up = co_await conversation_.ask_number("EOBOOT", Priority::poll);
  if (!after_power_up && after_power_up.error().kind != FaultKind::refused)
    co_return fail(after_power_up.error());
  motors_on_ = on;
  const bool as_after_power_up = after_power_up.value_or(0) == on;
  if (changed && as_after_power_up) {
    callbacks_.restarted(
        fmt::format("Motor power {}, although no command switched it", on < *before ? "went off" : "came on"),
        zero_in_doubt_ ? zero_in_doubt_->before.moved() : 0);
    co_return Result<>();
  }
  if (!zero_in_doubt_) co_return Result<>();
  if (as_after_power_up) {
    auto decided = co_await decide(*zero_in_doubt_);  // a stop may come first: the next round asks again
    if (!decided) co_return decided;
  }
  be_in_doubt(std::nullopt);
  co_return Result<>();
}

/// While a restart is in doubt, every wait fails.
void RestartWatch::be_in_doubt(std::optional<InDoubt> doubt) {
  zero_in_doubt_ = std::move(doubt);
  console_.snapshot.working = zero_in_doubt_.has_value();
}

Task<Result<>> RestartWatch::decide(InDoubt in_doubt) {
  if (in_doubt.before.program_ran) {
    auto goes_on = co_await a_program_runs();
    if (!goes_on) co_return fail(goes_on.error());
    if (*goes_on && in_doubt.at_zero) co_return Result<>();
  }
  if (!in_doubt.at_zero) {
    auto started = co_await power_up_starts_a_program();
    if (!started) co_return fail(started.error());
    if (!*started) co_return Result<>();
  }
  auto kept = co_await setup_.something_is_kept();
  if (!kept) co_return fail(kept.error());
  if (*kept) co_return Result<>();
  if (in_doubt.may_be_so)
    warn_of_doubt(in_doubt.before);
  else
    callbacks_.restarted("It did not answer for a while, and now counts from zero", in_doubt.before.moved());
  co_return Result<>();
}

// Either a power cycle or a sent command has set the counters; which, and how motions ended, cannot be known.
void RestartWatch::warn_of_doubt(const Reference& before) {
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    if (before.axes[ix(i)].then.moving) axis.ended_by = EndedBy::lost;
    if (axis.position == Steps(0)) axis.trust.doubt(Doubt::after_silence, console_.scheduler.now());
  }
  if (before.program_ran) console_.snapshot.program.ended_by = EndedBy::lost;
  console_.report(
      Notice::Kind::warning,
      "Check where the axes are, and home them before the next absolute move: replies were "
      "missing, and then all positions read zero. Either a command that was sent set them to zero, or the "
      "controller was switched off and on.");
}

Task<Result<bool>> RestartWatch::a_program_runs() {
  for (int n = 0; n < console_.model().programs; ++n) {
    auto state = co_await conversation_.ask_number(fmt::format("SASTAT{}", n), Priority::poll);
    if (!state) co_return fail(state.error());
    if (*state != 0) co_return true;
  }
  co_return false;
}

Task<Result<bool>> RestartWatch::power_up_starts_a_program() {
  auto started = co_await conversation_.ask_number("SLOAD", Priority::poll);
  if (!started && started.error().kind != FaultKind::refused) co_return fail(started.error());
  co_return started.value_or(0) != 0;
}

// A program that no command has started, and that power-up starts.
Task<Result<>> RestartWatch::look_at_start(int thread, Priority priority) {
  auto starts_at_power_up = co_await conversation_.ask_number("SLOAD", priority);
  if (!starts_at_power_up && starts_at_power_up.error().kind != FaultKind::refused)
    co_return fail(starts_at_power_up.error());
  if ((starts_at_power_up.value_or(0) >> thread & 1) != 0)
    callbacks_.restarted(
        fmt::format("Program {} is running, started by power-up and not by a command", thread), 0);
  co_return Result<>();
}

}  // namespace hw::arcus
