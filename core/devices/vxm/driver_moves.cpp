// The console's own moves: each is one run of a program that lst has shown empty. The program is emptied and
// the user's selection put back afterwards, so that the Run button never repeats a move of the console.
//
// S lasts beyond a run and cannot be read. A move with a speed of its own therefore ends by putting back what
// the user's last S said, or 2000 steps/s, the power-up value, if none was seen.
#include <cmath>

#include <fmt/format.h>

#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

constexpr double longest_jog_s = 30;    // a jog that nobody ends (a pulled cable) stops after this
constexpr int off_switch_steps = 4000;  // back off a home switch before the second approach (App. N p.67)
constexpr int homing_speed = hard_stop_safe_speed;  // the manual's limit for reliable homing (p.27)
constexpr Duration quick_patience = std::chrono::seconds(1);

std::size_t at(int axis) { return static_cast<std::size_t>(axis); }
bool on_slave(int axis) { return axis >= motors_per_controller; }

}  // namespace

// ---- may it

Result<> VxmDriver::may_run() const {
  if (halted_)
    return fail(FaultKind::refused, explain_error(halted_).what, "Nothing was sent.",
                explain_error(halted_).advice);
  if (stored_running_)
    return fail(FaultKind::refused,
                draft_.program.slot >= 0 ? fmt::format("Program {} is running.", draft_.program.slot)
                                         : std::string("A program is running."),
                "Nothing was sent.", "Wait until it ends, or stop it.");
  if (job_.active() && job_.legs.front().axis >= 0)
    return fail(FaultKind::refused,
                fmt::format("Motor {} is still moving, and a VXM does one thing at a time.",
                            job_.legs.front().axis + 1),
                "Nothing was sent.", "Wait until it ends, or stop it.");
  if (job_.active())
    return fail(FaultKind::refused, "The command before is still under way.", "Nothing was sent.",
                "Try again.");
  const auto input_mode = param("I");
  constexpr std::uint32_t in_4 = 1u << 3;
  if (input_mode && *input_mode & inputs_stop && draft_.inputs_known & in_4 && !(draft_.inputs & in_4))
    return fail(FaultKind::refused,
                "The Stop button or input 4 is held: the controller starts nothing while it is low.",
                "Nothing was sent.", "Release it, then try again.");
  return {};
}

Result<> VxmDriver::may_move(int axis) const {
  if (axis < 0 || axis >= draft_.axis_count)
    return fail(FaultKind::refused, fmt::format("There is no motor {} here.", axis + 1), "Nothing was sent.");
  if (on_slave(axis) && !slave_present_)
    return fail(
        FaultKind::refused,
        fmt::format("Motor {} belongs to a second controller, and none answers on the VXM bus.", axis + 1),
        "Nothing was sent.", "Check the Slave's power and cable, then reconnect.");
  return may_run();
}

Result<int> VxmDriver::checked_speed(Pps speed) const {
  const double value = std::round(speed.value);
  if (value == 0) return 0;
  if (value < min_speed || value > max_speed)
    return fail(FaultKind::refused,
                fmt::format("{:.0f} steps/s is not possible: a VXM motor takes {} to {} steps/s.", value,
                            min_speed, max_speed),
                "Nothing was sent.");
  return static_cast<int>(value);
}

void VxmDriver::warn_of_motor_type(int axis) {
  if (std::exchange(type_warned_[at(axis)], true) || param(fmt::format("M{}M", axis + 1)) != 0) return;
  tell(Notice::Kind::warning,
       fmt::format("Motor {0} is set to type 0, the factory value for the smallest motors: a larger one only "
                   "buzzes. The "
                   "move was sent. If motor {0} does not turn, choose its type in Setup, Motors.",
                   axis + 1));
}

// ---- which program

// Not one that starts by itself (4 after power-up or after Stop), nor one that a Slave's program runs with.
bool VxmDriver::may_be_scratch(int slot) const {
  const auto mode = param("DM").value_or(0), inputs = param("I").value_or(0);
  if (slot == 4 && (mode & mode_program_4_first || inputs & inputs_program_4)) return false;
  const auto coupled = param("PMA").value_or(pma_off);
  if (coupled == pma_off) return true;
  const auto excepted = coupled == -5 ? 0 : -coupled;
  return coupled >= 0 ? slot != coupled : slot == excepted;
}

Task<Result<int>> VxmDriver::find_scratch() {
  if (!sizes_read_ || !essentials_read_) {
    auto read = co_await catch_up();
    if (!read) co_return fail(read.error());
  }
  const auto& used = draft_.slot_bytes_used;
  if (confirmed_scratch_ >= 0 && used[at(confirmed_scratch_)] == 0 && may_be_scratch(confirmed_scratch_))
    co_return confirmed_scratch_;
  for (const bool selected_too : {false, true})  // the selected one only when no other is left
    for (int slot = program_count - 1; slot >= 0; --slot) {
      if ((slot == selected_) != selected_too || used[at(slot)] != 0 || !may_be_scratch(slot)) continue;
      auto chosen = co_await say(select_program(slot), Priority::intent);
      if (!chosen) co_return fail(chosen.error());
      auto listing = co_await ask_listing(Priority::intent);
      auto back = co_await say(select_program(selected_), Priority::intent);
      if (!listing) co_return fail(listing.error());
      if (!back) co_return fail(back.error());
      if (listing->slot == slot && listing->free_bytes == program_bytes && listing->commands.empty()) {
        confirmed_scratch_ = slot;
        co_return slot;
      }
      draft_.slot_bytes_used[at(slot)] = static_cast<std::int16_t>(program_bytes - listing->free_bytes);
    }
  const Fault none(
      FaultKind::refused,
      "All five programs of the controller hold commands, and a move of the console needs an empty one for "
      "its time.",
      "Nothing was sent and nothing was erased.",
      "Which may be emptied? Save its text if it is needed, clear it, and move again.");
  tell(Notice::Kind::question, none.sentence());
  co_return fail(none);
}

// ---- legs

std::string VxmDriver::leg_program(const Leg& leg) {
  std::string text;
  if (hold_on_) text += "H";  // else it would hold before the first command
  text += empty_program(scratch_);
  for (const int axis : {leg.axis, leg.second_axis}) {
    if (axis < 0) continue;
    const int usual = known_speed_[at(axis)].value_or(default_speed);
    if (leg.speed > 0)
      text += speed(axis + 1, leg.speed);
    else if (our_speed_[at(axis)])
      text += speed(axis + 1, usual);
  }
  text += leg.text;
  for (const int axis : {leg.axis, leg.second_axis})
    if (axis >= 0 && leg.speed > 0) text += speed(axis + 1, known_speed_[at(axis)].value_or(default_speed));
  return text + "R";
}

Task<Result<>> VxmDriver::begin(Job job) {
  auto slot = co_await find_scratch();
  if (!slot) co_return fail(slot.error());
  scratch_ = *slot;
  for (int i = 0; i < draft_.axis_count; ++i) draft_.axes[i].ended_by = EndedBy::nothing;
  job_ = std::move(job);
  co_return co_await start_leg();
}

Task<Result<>> VxmDriver::start_leg() {
  const Leg& leg = job_.legs.front();
  job_.leg_over = job_.limit_reported = false;
  for (const int axis : {leg.axis, leg.second_axis})
    if (axis >= 0) our_speed_[at(axis)] = our_speed_[at(axis)] || leg.speed > 0;
  std::string program = leg_program(leg);
  hold_on_ = false;
  show_leg(leg);
  auto sent = co_await say(std::move(program), Priority::intent);
  if (sent) co_return sent;
  // A stop came first: nothing of it has gone out.
  const std::deque<Leg> never = std::exchange(job_.legs, {});
  if (!never.empty()) show_leg_ended(never.front(), EndedBy::stop);
  job_ = Job();
  co_return sent;
}

void VxmDriver::show_leg(const Leg& leg) {
  if (leg.activity == Activity::idle) return;
  for (const int index : {leg.axis, leg.second_axis}) {
    if (index < 0) continue;
    AxisState& axis = draft_.axes[index];
    axis.activity = leg.activity;
    axis.direction = static_cast<std::int8_t>(factor(leg.sign));
    axis.has_target = leg.target.has_value() && index == leg.axis;
    if (axis.has_target) {
      axis.target = *leg.target;
      if (axis.position_known)
        axis.direction = static_cast<std::int8_t>(axis.target < axis.position ? -1 : 1);
    }
    axis.speed = Pps{static_cast<double>(leg.speed > 0 ? leg.speed : known_speed_[at(index)].value_or(0))};
  }
}

// Called whenever a leg may have ended: reads where it ended, and goes on to the next one or cleans up.
Task<Result<>> VxmDriver::finish_leg() {
  if (!job_.active() || !job_.leg_over) {
    if (!busy() && scratch_ >= 0) co_return co_await clean_scratch();
    co_return Result<>();
  }
  const Leg leg = job_.legs.front();
  auto read = co_await read_positions(Priority::poll, true);
  if (read && leg.activity != Activity::idle) read = co_await read_io('?', Priority::poll);
  if (!read) co_return read;
  if (!job_.active()) co_return Result<>();
  const EndedBy ended_by = how_it_ended(leg);
  const bool cut_off = ended_by == EndedBy::abort || ended_by == EndedBy::error || ended_by == EndedBy::lost;
  for (const int axis : {leg.axis, leg.second_axis})
    if (axis >= 0 && !cut_off) our_speed_[at(axis)] = false;
  auto again = next_jog_leg(leg, ended_by);
  job_.legs.pop_front();
  if (again) job_.legs.push_back(std::move(*again));
  if (ended_by != EndedBy::target) job_.legs.clear();
  show_leg_ended(leg, ended_by);
  if (job_.active()) co_return co_await start_leg();
  job_ = Job();
  stopping_ = Stopping::no;
  co_return co_await clean_scratch();
}

EndedBy VxmDriver::how_it_ended(const Leg& leg) const {
  if (job_.ended_by != EndedBy::nothing) return job_.ended_by;
  if (leg.axis < 0 || leg.activity == Activity::idle || leg.activity == Activity::homing)
    return EndedBy::target;
  const AxisState& axis = draft_.axes[leg.axis];
  if (!leg.target || axis.position == *leg.target) return EndedBy::target;
  const bool at_limit = axis.direction > 0 ? axis.limit_plus : axis.limit_minus;
  return at_limit || job_.limit_reported ? EndedBy::limit : EndedBy::stop;
}

void VxmDriver::show_leg_ended(const Leg& leg, EndedBy ended_by) {
  for (const int index : {leg.axis, leg.second_axis}) {
    if (index < 0) continue;
    AxisState& axis = draft_.axes[index];
    if (leg.activity != Activity::idle) {
      axis.ended_by = ended_by;
      if (ended_by == EndedBy::limit && !job_.jog)
        tell(Notice::Kind::warning,
             fmt::format("The {} limit switch ended the move of motor {} at {} steps{}.",
                         axis.direction > 0 ? '+' : '-', index + 1, axis.position.value,
                         axis.has_target
                             ? fmt::format(", {} steps before {}",
                                           std::abs((axis.target - axis.position).value), axis.target.value)
                             : ""));
      axis.activity = Activity::idle;
      axis.direction = 0;
      axis.has_target = false;
      axis.speed = Pps{};
    }
    if (leg.zeroes && ended_by == EndedBy::target) axis.position_doubtful = false;
  }
}

Task<Result<>> VxmDriver::clean_scratch() {
  if (scratch_ < 0) co_return Result<>();
  auto cleaned =
      co_await say(empty_program(scratch_) + select_program(std::max(selected_, 0)), Priority::poll);
  if (!cleaned) co_return cleaned;
  scratch_ = -1;
  co_return Result<>();
}

// Something that is over at once: its end is waited for.
Task<Result<>> VxmDriver::run_quickly(Leg leg) {
  Job job;
  job.legs.push_back(std::move(leg));
  auto begun = co_await begin(std::move(job));
  if (!begun) co_return begun;
  const Instant deadline = scheduler_.now() + quick_patience;
  bool in_time = true;
  while (link_ && job_.active() && !job_.leg_over && in_time) in_time = co_await news_.wait_until(deadline);
  if (!in_time) {
    auto state = co_await ask_state(Priority::intent);
    if (!state) co_return fail(state.error());
    auto taken = co_await take_state(*state);
    if (!taken) co_return taken;
  }
  co_return co_await finish_leg();
}

// A leg that was cut off may have left its own speed behind.
Task<Result<>> VxmDriver::restore_speeds() {
  Leg leg;
  for (int axis = 0; axis < draft_.axis_count; ++axis)
    if (our_speed_[at(axis)]) leg.text += speed(axis + 1, known_speed_[at(axis)].value_or(default_speed));
  if (leg.text.empty()) co_return Result<>();
  auto restored = co_await run_quickly(std::move(leg));
  if (restored) our_speed_.fill(false);
  co_return restored;
}

// ---- moves

Task<Result<>> VxmDriver::move(const std::vector<AxisTarget>& targets, Pps wish, bool relative) {
  auto speed = checked_speed(wish);
  if (!speed) co_return fail(speed.error());
  std::vector<AxisTarget> wanted;  // positions, as far as they are known
  for (const AxisTarget& t : targets) {
    const int axis = t.axis.index;
    if (auto may = may_move(axis); !may) co_return may;
    if (relative && (t.value.value < -max_index || t.value.value > max_index))
      co_return fail(
          FaultKind::refused,
          fmt::format("{} steps are too many for one move: a VXM takes up to {}.", t.value.value, max_index),
          "Nothing was sent.");
    const AxisState& state = draft_.axes[axis];
    const Steps goal = relative ? state.position + t.value : t.value;
    if ((!relative || state.position_known) && (goal < catalog_.position_min || goal > catalog_.position_max))
      co_return fail(FaultKind::refused,
                     fmt::format("Position {} of motor {} lies outside the controller's register, {} to {}.",
                                 goal.value, axis + 1, position_min, position_max),
                     "Nothing was sent.");
    if (!relative && state.position_doubtful)
      tell(Notice::Kind::warning,
           fmt::format("The position of motor {} is doubtful: {} may lie elsewhere than before.", axis + 1,
                       t.value.value));
    if (relative && t.value.value == 0) continue;
    warn_of_motor_type(axis);
    AxisTarget w = t;
    w.value = goal;
    wanted.push_back(w);
  }
  if (wanted.empty()) co_return Result<>();
  auto read = co_await read_positions(Priority::intent, true);
  if (!read) co_return read;
  Job job;
  for (const AxisTarget& w : wanted) {
    const int axis = w.axis.index;
    Leg leg;
    leg.axis = axis;
    leg.activity = Activity::moving;
    leg.target = w.value;
    leg.speed = *speed;
    const Steps distance = w.value - draft_.axes[axis].position;
    leg.sign = distance.value < 0 ? Sign::minus : Sign::plus;
    // Moves on the two controllers can run together; the Slave's must stand first (App. G p.47).
    Leg* partner = job.legs.empty() ? nullptr : &job.legs.back();
    const bool pairs = partner && partner->second_axis < 0 && on_slave(partner->axis) != on_slave(axis);
    leg.text = relative ? index_by(axis + 1, distance) : index_to(axis + 1, w.value);
    const Steps other = partner ? *partner->target - draft_.axes[partner->axis].position : Steps{};
    if (pairs && distance.value != 0 && other.value != 0) {
      partner->second_axis = axis;
      partner->text = on_slave(axis) ? index_pair(axis + 1, distance, partner->axis + 1, other)
                                     : index_pair(partner->axis + 1, other, axis + 1, distance);
      continue;
    }
    job.legs.push_back(std::move(leg));
  }
  co_return co_await begin(std::move(job));
}

VxmDriver::Leg VxmDriver::jog_leg(int axis, Sign sign, int speed) const {
  const AxisState& state = draft_.axes[axis];
  const Steps room =
      sign == Sign::plus ? catalog_.position_max - state.position : state.position - catalog_.position_min;
  const std::int64_t distance = std::min<std::int64_t>(std::llround(speed * longest_jog_s), room.value);
  Leg leg;
  leg.axis = axis;
  leg.activity = Activity::jogging;
  leg.sign = sign;
  leg.speed = speed;
  leg.target = state.position + Steps{factor(sign) * distance};
  leg.text = index_by(axis + 1, Steps{factor(sign) * distance});
  return leg;
}

std::optional<VxmDriver::Leg> VxmDriver::next_jog_leg(const Leg& last, EndedBy ended_by) const {
  if (!job_.jog || ended_by != EndedBy::target) return std::nullopt;
  Leg leg = jog_leg(last.axis, last.sign, last.speed);
  if (*leg.target == draft_.axes[last.axis].position) return std::nullopt;
  return leg;
}

Task<Result<>> VxmDriver::jog(const intent::JogStart& wish) {
  const int axis = wish.axis.index;
  if (auto may = may_move(axis); !may) co_return may;
  auto speed = checked_speed(wish.speed.value == 0 ? catalog_.jog_speed : wish.speed);
  if (!speed) co_return fail(speed.error());
  warn_of_motor_type(axis);
  Job job;
  job.jog = true;
  job.legs.push_back(jog_leg(axis, wish.sign, *speed));
  if (*job.legs.front().target == draft_.axes[axis].position)
    co_return fail(FaultKind::refused,
                   fmt::format("Motor {} stands at the end of the controller's position register.", axis + 1),
                   "Nothing was sent.", "Set its position to zero first.");
  co_return co_await begin(std::move(job));
}

Task<Result<>> VxmDriver::home(const intent::Home& wish) {
  const int axis = wish.axis.index;
  if (auto may = may_move(axis); !may) co_return may;
  if (wish.mode < 0 || wish.mode >= static_cast<int>(catalog_.homing_modes.size()))
    co_return fail(FaultKind::refused, fmt::format("There is no way of homing number {}.", wish.mode),
                   "Nothing was sent.");
  if (param("DM").value_or(0) & mode_nf90 && wish.sign == Sign::plus)
    co_return fail(FaultKind::refused,
                   fmt::format("In NF90 emulation I{}M0 runs to zero, not to the + limit switch.", axis + 1),
                   "Nothing was sent.",
                   "Switch NF90 emulation off in Setup (DM), or home to the - limit switch.");
  warn_of_motor_type(axis);
  Leg to_switch;
  to_switch.axis = axis;
  to_switch.activity = Activity::homing;
  to_switch.sign = wish.sign;
  to_switch.speed = std::min(known_speed_[at(axis)].value_or(default_speed), homing_speed);
  to_switch.text = vxm::home(axis + 1, wish.sign);
  Leg zero;
  zero.axis = axis;
  zero.text = zero_here(axis + 1);
  zero.zeroes = true;
  Leg off_switch = to_switch;
  off_switch.sign = -wish.sign;
  off_switch.text = index_by(axis + 1, Steps{factor(off_switch.sign) * off_switch_steps});
  Job job;
  job.legs.push_back(to_switch);
  if (wish.mode == 2) {  // Appendix N p.67: always the same direction at the end
    job.legs.push_back(off_switch);
    job.legs.push_back(to_switch);
  }
  if (wish.mode != 0) job.legs.push_back(zero);
  co_return co_await begin(std::move(job));
}

Task<Result<>> VxmDriver::set_position(const intent::SetPosition& wish) {
  if (wish.value.value != 0)
    co_return fail(FaultKind::refused,
                   fmt::format("A VXM can only call the present position zero, not {}.", wish.value.value),
                   "Nothing was sent.", "Set zero here, or move to where zero shall be first.");
  if (auto may = wish.axis < 0 ? may_run() : may_move(wish.axis); !may) co_return may;
  if (wish.axis < 0) {
    auto said = co_await say("N", Priority::intent);
    if (!said) co_return said;
    for (int i = 0; i < draft_.axis_count; ++i) draft_.axes[i].position_doubtful = false;
  } else {
    Leg leg;
    leg.axis = wish.axis;
    leg.text = zero_here(wish.axis + 1);
    leg.zeroes = true;
    auto done = co_await run_quickly(std::move(leg));
    if (!done) co_return done;
  }
  auto read = co_await read_positions(Priority::intent, true);
  if (!read) co_return read;
  for (int i = 0; i < draft_.axis_count; ++i)
    if ((wish.axis < 0 || wish.axis == i) && draft_.axes[i].enabled && draft_.axes[i].position.value != 0)
      co_return fail(FaultKind::controller,
                     fmt::format("Motor {} was to read zero, but the controller says {}.", i + 1,
                                 draft_.axes[i].position.value),
                     "Its position is as before.", "Try again; look whether the Stop button is held.");
  co_return Result<>();
}

// U4, U5 and their like are stored commands: they too need a run.
Task<Result<>> VxmDriver::set_output(const intent::SetOutput& wish) {
  if (wish.number < 1 || wish.number > outputs_per_controller)
    co_return fail(FaultKind::refused,
                   fmt::format("There is no output {}: a VXM has outputs 1 to 4.", wish.number),
                   "Nothing was sent.");
  if (auto may = may_run(); !may) co_return may;
  Leg leg;
  leg.text = output(wish.number, wish.on);
  auto done = co_await run_quickly(std::move(leg));
  if (!done) co_return done;
  auto read = co_await read_io('$', Priority::intent);
  if (!read) co_return read;
  const bool is_on = draft_.outputs >> (wish.number - 1) & 1;
  if (is_on == wish.on) co_return Result<>();
  co_return fail(FaultKind::controller,
                 fmt::format("Output {} was to go {}, but the controller says that it is {}.", wish.number,
                             wish.on ? "on" : "off", is_on ? "on" : "off"),
                 "It was asked for once.", "Look whether the Stop button is held, then try again.");
}

}  // namespace hw::vxm
