// Noticing that the controller was switched off and on, and what is left of it then, or behind a lost wire.
#include <algorithm>
#include <cstdlib>
#include <limits>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {

// How fast a counter may come to zero by itself. An axis on its way elsewhere does not rest there.
Pps ArcusDriver::fastest_way_home(int index) const {
  const AxisState& axis = draft_.axes[index];
  const AxisMind& mind = minds_[ix(index)];
  if (!moving(index)) return Pps{};
  if (mind.ours && (mind.wanted == Activity::jogging || mind.stopping)) return axis.speed;
  if (mind.ours && axis.has_target && axis.target != Steps(0)) return Pps{};
  return Pps(std::numeric_limits<double>::infinity());
}

ArcusDriver::Stood ArcusDriver::where_all_stand() const {
  Stood stood;
  stood.seen_at = scheduler_.now();
  for (int i = 0; i < axis_count(); ++i) {
    stood.axes[ix(i)] = {draft_.axes[i].position, fastest_way_home(i),
                         draft_.axes[i].in_counts ? Steps(loop_tolerance(i)) : Steps(0), moving(i)};
  }
  return stood;
}

// Whatever is sent or heard goes through here before it is: a change that it explains is no power-cycle.
void ArcusDriver::may_set(std::string_view command) {
  if (may_set_counter(command)) counters_.may_be_set();
  if (may_switch_motor(command)) motors_.may_be_set();
}

// After power-up every counter reads zero wherever the motors stand. Texts that may set a counter, homing and
// programs do that too. See also look_at_motors() and read_what_power_keeps(), for one that stood at zero.
void ArcusDriver::look_at_counters(Unexplained::Mark asked) {
  const bool unexplained = counters_.answered(asked);
  const auto before = std::exchange(stood_, where_all_stand());
  if (!before || !unexplained || draft_.program.run == RunState::running) return;
  constexpr double between_two_looks = 1;  // s, and more where the wire was slow
  const double elapsed = between_two_looks + seconds(scheduler_.now() - before->seen_at);
  bool jumped = false;
  for (int i = 0; i < axis_count(); ++i) {
    const AxisState& axis = draft_.axes[i];
    if (runs(i) || axis.position != Steps(0) || axis.encoder != Steps(0)) return;
    const Stood::Axis& then = before->axes[ix(i)];
    const double reach = static_cast<double>(then.room.value) +
                         (then.towards_zero.value > 0 ? then.towards_zero.value * elapsed : 0);
    jumped = jumped || static_cast<double>(std::abs(then.position.value)) > reach;
  }
  if (!jumped) return;
  restarted("All positions read zero");
  for (int i = 0; i < axis_count(); ++i)
    if (before->axes[ix(i)].moved) draft_.axes[i].ended_by = EndedBy::lost;
}

// The motors have power, or none, as after power-up (EOBOOT), and nobody has switched them.
Task<Result<>> ArcusDriver::look_at_motors(Unexplained::Mark asked) {
  std::int64_t on = 0;
  for (int i = 0; i < axis_count(); ++i) on |= std::int64_t{draft_.axes[i].enabled} << i;
  const bool a_program_may = programs_switch_motors() && (scheduler_.now() <= programs_run_until_ || called_);
  const bool unexplained = motors_.answered(asked) && !a_program_may;
  const auto before = std::exchange(motors_on_, on);
  if (!before || *before == on || !unexplained) co_return Result<>();
  motors_on_ = before;  // until it is sure: the next round asks again
  auto again = co_await ask_number("EO", Priority::poll);  // a digit may have been garbled
  if (!again) co_return fail(again.error());
  if (*again != on) co_return Result<>();
  auto after_power_up = co_await ask_number("EOBOOT", Priority::poll);
  if (!after_power_up && after_power_up.error().kind != FaultKind::refused)
    co_return fail(after_power_up.error());
  motors_on_ = on;
  if (after_power_up.value_or(0) == on) restarted(on < *before ? "Motor power went off" : "Motor power came on");
  co_return Result<>();
}

bool ArcusDriver::programs_switch_motors() const { return !stored_code_ || stored_code_->switches_motors; }

// What was on its way when the wire was lost had all the time it wanted. A stop that nobody answered explains
// no zero; motor power that was to be switched may have been.
Task<Result<>> ArcusDriver::look_back_over_the_loss() {
  if (stood_)
    for (Stood::Axis& axis : stood_->axes) axis.towards_zero = Pps{}, axis.moved = false;
  look_at_counters(counters_.settle());
  co_return co_await look_at_motors(motors_.ask());
}

void ArcusDriver::restarted(std::string_view how_it_shows) {
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
  end_feed();
  stood_.reset();
  motors_on_.reset();
  for (int i = 0; i < axis_count(); ++i) {
    minds_[static_cast<std::size_t>(i)] = AxisMind();
    draft_.axes[i].has_target = false;
    draft_.axes[i].trust.doubt(Doubt::power_cut, scheduler_.now());
  }
  tell(Notice::Kind::warning,
       fmt::format(
           "{}, and nothing that was sent does that: the controller was switched off and on, or another "
           "program set it. What was not stored is gone; it is read afresh. Find home before the next "
           "absolute move.",
           how_it_shows));
}

void ArcusDriver::wire_lost() {
  if (!station_) return;
  station_ = nullptr;
  lost_while_busy_ = lost_while_busy_ || any_moving();
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
  for (ThreadState& t : draft_.threads) t = ThreadState();
  draft_.inputs_known = draft_.outputs_known = draft_.analog_known = 0;
  draft_.readouts_known.reset();
  draft_.variables_known.reset();
}

}  // namespace hw::arcus
