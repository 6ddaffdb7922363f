// Stopping, by decision V102: D ends a move of the console. A stored program is held (H), its motor ramped
// down (D) and ended by K once everything stands. A second stop is K at once. In Local mode: on-line (F),
// then K.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

// At acceleration 1 from the highest speed; nothing takes longer to ramp down.
constexpr Duration longest_ramp = from_seconds(max_speed / (accel_unit * min_accel));
constexpr Duration look_again = Millis(60);
constexpr Duration kill_patience = Millis(300);

}  // namespace

Task<Result<>> VxmDriver::stop(int axis, bool at_once) {
  if (!station_)
    co_return fail(FaultKind::lost, "Stop does not reach the controller: there is no connection.",
                   "Nothing was sent.", "Use its power switch.");
  end_waits();
  // The first stop of all, or of another motor, is no second one of what ramps down already.
  const bool other = stopping_ == Stopping::ramp && ramped_ >= 0 && ramped_ != axis;
  if (at_once || (stopping_ != Stopping::no && !other) || halted_) co_return co_await kill(false);
  if (other) {
    if (axis >= 0) co_return Result<>();
    ramped_ = axis;
    co_return co_await say("D", Priority::stop);  // the one before may not have come through
  }
  if (mode_ == Mode::local) {
    auto said = co_await say("F", Priority::stop);
    if (!said) co_return said;
    stay_local_ = false;
    mode_ = Mode::on_line;
    co_return co_await kill(false);
  }
  if (job_.active()) {
    const bool concerned =
        axis < 0 || job_.legs.front().axis == axis || job_.legs.front().second_axis == axis;
    const bool later_legs = job_.legs.size() > 1;
    drop_later_legs(axis);
    if (!concerned) co_return Result<>();
    job_.legs.resize(1);
    job_.jog = false;
    if (!job_.leg_over) job_.ended_by = EndedBy::stop;
    stopping_ = Stopping::ramp;
    ramped_ = axis;
    for (const int index : {job_.legs.front().axis, job_.legs.front().second_axis})
      if (index >= 0 && draft_.axes[index].activity != Activity::idle)
        draft_.axes[index].activity = Activity::stopping;
    job_.cut_whole = job_.legs.front().second_axis < 0 && !later_legs;
    const int turning = std::max(job_.legs.front().axis, 0);
    auto said = co_await say("D", Priority::stop);
    if (!said) co_return said;
    co_return co_await watch_the_ramp(turning);
  }
  if (stored_running_) co_return co_await stop_program();
  co_return co_await stop_unknown();
}

void VxmDriver::drop_later_legs(int axis) {
  std::erase_if(job_.legs, [&](const Leg& leg) {
    if (&leg == &job_.legs.front()) return false;
    const bool stops = axis < 0 || leg.axis == axis || leg.second_axis == axis;
    if (stops && axis >= 0 && leg.second_axis >= 0)
      tell(Notice::Kind::warning, fmt::format("Motors {} and {} were to move together: both stay now.",
                                              leg.axis + 1, leg.second_axis + 1));
    return stops;
  });
}

bool VxmDriver::ramps_down() const {
  return station_ && job_.active() && !job_.leg_over && stopping_ == Stopping::ramp;
}

// D is not answered. One that did not get through shows by a motor that loses no speed: it is said again, and
// what still turns after the longest ramp is killed.
Task<Result<>> VxmDriver::watch_the_ramp(int turning) {
  constexpr Duration look = Millis(300);
  constexpr double least_loss = min_accel * accel_unit * seconds(look) / 2;
  const Instant give_up = scheduler_.now() + longest_ramp + look;
  const std::size_t axis = ix(turning);
  const bool can_be_seen =
      turning < motors_per_controller;  // a Slave's motors cannot be read while they turn
  bool again = false;
  double before = seen_speed_[axis];
  while (ramps_down() && scheduler_.now() < give_up) {
    const Instant next = scheduler_.now() + look;
    while (ramps_down() && scheduler_.now() < next) co_await news_.wait_until(next);
    if (ramps_down() && (can_be_seen ? seen_speed_[axis] > before - least_loss : !again)) {
      again = true;
      auto said = co_await say("D", Priority::stop);
      if (!said) co_return said;
    }
    before = seen_speed_[axis];
  }
  if (!station_) co_return fail(FaultKind::lost, "The connection was lost while the motor was stopping.");
  if (ramps_down()) co_return co_await kill(false);
  co_return Result<>();
}

// As far as is known nothing runs. That may be a fifth of a second old.
Task<Result<>> VxmDriver::stop_unknown() {
  const Instant sent_at = scheduler_.now();
  auto said = co_await say("D", Priority::stop);
  if (!said) co_return said;
  // In Local mode D is answered; nothing may be sent into that answer.
  if (station_) co_await scheduler_.sleep_for(station_->wire_time(4) + Millis(2));
  if (heard_at_ > sent_at) co_await wait_for_quiet();
  auto state = co_await ask_state(Priority::stop);
  if (!state) co_return fail(state.error());
  if (*state == ready) co_return Result<>();
  if (*state == vxm::busy) {
    show_running(-1);
    co_return co_await stop_program();
  }
  auto on_line = co_await say("F", Priority::stop);
  if (!on_line) co_return on_line;
  co_return co_await kill(*state == jog_idle);
}

Task<Result<>> VxmDriver::stop_program() {
  stopping_ = Stopping::program;
  if (draft_.program.run == RunState::held) co_return co_await kill(true);
  if (hold_doubtful_) co_return co_await kill(false);
  if (!hold_on_) {
    auto held = co_await switch_hold("H", true, Priority::stop);
    if (!held) co_return held;
    // Between two commands the hold is told at once, and D into that listing would be an overrun.
    if (station_) co_await scheduler_.sleep_for(station_->wire_time(2) + Millis(1));
  }
  if (stored_running_ && draft_.program.run != RunState::held && stopping_ == Stopping::program) {
    auto ramped = co_await say("D", Priority::stop);
    if (!ramped) co_return ramped;
  }
  const bool standing = co_await wait_for_standstill(scheduler_.now() + longest_ramp);
  if (stopping_ != Stopping::program || !station_)
    co_return Result<>();  // a second stop has killed it, or the wire is gone
  if (!stored_running_) {
    // It ended by itself. The hold must not keep the next run.
    stopping_ = Stopping::no;
    co_return co_await switch_hold("H", false, Priority::stop);
  }
  co_return co_await kill(standing);
}

// Held before a command, ended, or two readings alike after D: what moves slower than a step between them has
// no ramp to speak of. Motors 3 and 4 cannot be read while they turn, so there only the ramp's longest time
// tells.
Task<bool> VxmDriver::wait_for_standstill(Instant give_up) {
  std::array<Steps, motors_per_controller> before{}, now{};
  bool first = true;
  while (station_ && stored_running_ && stopping_ == Stopping::program && scheduler_.now() < give_up) {
    if (draft_.program.run == RunState::held) co_return true;
    const int motors = std::min(draft_.axis_count, motors_per_controller);
    for (int i = 0; i < motors; ++i) {
      auto position = co_await ask_position(i + 1, Priority::stop);
      if (!position) co_return false;
      show_position(i, *position);
      now[static_cast<std::size_t>(i)] = *position;
    }
    if (!first && now == before && !slave_present_) co_return true;
    before = now;
    first = false;
    const Instant next = std::min(scheduler_.now() + look_again, give_up);
    while (station_ && stored_running_ && draft_.program.run != RunState::held && scheduler_.now() < next)
      co_await news_.wait_until(next);
  }
  co_return scheduler_.now() >= give_up || draft_.program.run == RunState::held;
}

Task<Result<>> VxmDriver::kill(bool standing) {
  if (!standing) doubt_positions();
  const bool something_ran = busy() || halted_;
  killed_at_ = scheduler_.now();
  auto reply = co_await ask("K", ReplyShape::bytes(1), Priority::stop, before_prompt, kill_patience);
  killed_at_ = scheduler_.now();
  if (!reply && reply.error().kind != FaultKind::lost)
    co_return fail(FaultKind::no_answer,
                   "K was sent to stop everything, but the controller did not confirm it.",
                   "Nothing else was sent.", "Watch the motors. If one still turns, use the power switch.");
  if (!reply) co_return fail(reply.error());
  killed(standing ? EndedBy::stop : EndedBy::abort);
  if (something_ran && draft_.outputs_known && draft_.outputs)
    tell(Notice::Kind::info, "K ended the run; it has also switched the outputs off.");
  show_worst();
  if (changed_) changed_();
  co_return Result<>();
}

// What K leaves: nothing runs, no hold, no error.
void VxmDriver::killed(EndedBy ended_by) {
  killed_at_ = scheduler_.now();
  halted_ = 0;
  ++stops_said_;
  hold_on_ = hold_doubtful_ = false;
  stopping_ = Stopping::no;
  if (job_.active()) {
    job_.legs.resize(1);
    job_.jog = false;
    job_.ended_by = EndedBy::abort;
    job_.leg_over = true;
  }
  if (stored_running_) run_ended(ended_by);
  if (draft_.program.run == RunState::error) draft_.program.run = RunState::idle;
  for (int i = 0; i < draft_.axis_count; ++i)
    if (draft_.axes[i].activity == Activity::error) draft_.axes[i].activity = Activity::idle;
  news_.notify();
}

// K above 1000 steps/s may cost steps that the controller does not know of (p.23). An unknown speed counts as
// fast.
void VxmDriver::doubt_positions() {
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    const bool turns = axis.activity == Activity::moving || axis.activity == Activity::jogging ||
                       axis.activity == Activity::homing || axis.activity == Activity::stopping;
    const bool hidden = stored_running_ && i >= motors_per_controller && slave_present_;
    if (!turns && !hidden) continue;
    const double told = axis.speed.value;
    const double speed = told > 0                     ? told
                         : stored_running_ && !hidden ? seen_speed_[static_cast<std::size_t>(i)]
                                                      : default_speed;
    if (speed <= hard_stop_safe_speed) continue;
    axis.trust.doubt(Doubt::killed, scheduler_.now());
    tell(Notice::Kind::warning, fmt::format("Motor {} was stopped without a ramp at about {:.0f} steps/s. "
                                            "Above {} steps/s it may have lost steps: "
                                            "its position is doubtful until it is homed or set to zero.",
                                            i + 1, speed, hard_stop_safe_speed));
  }
}

// What runs has come to its end, by itself or by force.
void VxmDriver::run_ended(EndedBy ended_by) {
  if (job_.active()) {
    job_.ended_by = ended_by;
    job_.leg_over = true;
  }
  const bool was_running = std::exchange(stored_running_, false);
  if (stopping_ != Stopping::program) stopping_ = Stopping::no;
  ProgramState& p = draft_.program;
  if (!was_running) return;
  p.run = RunState::idle;
  if (p.ended_by == EndedBy::nothing || ended_by != EndedBy::target) p.ended_by = ended_by;
  if (ended_by == EndedBy::target) {
    ended_run_ = p.slot;
    draft_.working = true;  // until the switches have told what ended it
  }
  p.owned = false;
  p.stepping = false;
  p.command = -1;
  p.command_told = false;
  p.slot = static_cast<std::int8_t>(selected_);
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    const bool turned = axis.activity != Activity::idle && axis.activity != Activity::unknown;
    if (turned && ended_by != EndedBy::target) axis.ended_by = ended_by;
    if (turned) axis.activity = Activity::idle;
    axis.direction = 0;
  }
}

}  // namespace hw::vxm
