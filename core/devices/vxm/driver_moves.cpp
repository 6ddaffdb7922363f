// What the console wants to move, as legs: moves, jogs, homing, zero, outputs; and whether it may now.
#include <cmath>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

constexpr double longest_jog_s = 30;    // a jog that nobody ends (a pulled cable) stops after this
constexpr int off_switch_steps = 4000;  // back off a home switch before the second approach (App. N p.67)
constexpr int homing_speed = hard_stop_safe_speed;  // the manual's limit for reliable homing (p.27)

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
  const auto input_mode = parameters_.value("I");
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
  if (on_slave(axis) && !nameplate_.has_slave())
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
  if (std::exchange(type_warned_[ix(axis)], true) || parameters_.value(fmt::format("M{}M", axis + 1)) != 0)
    return;
  console_.tell(
      Notice::Kind::warning,
      fmt::format("Motor {0} is set to type 0, the factory value for the smallest motors: a larger one only "
                  "buzzes. The "
                  "move was sent. If motor {0} does not turn, choose its type in Parameters, Motors.",
                  axis + 1));
}

// ---- moves

Task<Result<>> VxmDriver::move(const std::vector<AxisTarget>& targets, Pps wish, bool relative) {
  auto speed = checked_speed(wish);
  if (!speed) co_return fail(speed.error());
  // Where the axes stand is read first: the last round may have asked before a program came to its end.
  if (auto may = may_move_all(targets, relative); !may) co_return may;
  auto read = co_await read_positions(Priority::intent, true);
  if (!read) co_return read;
  auto goals = checked_goals(targets, relative);
  if (!goals) co_return fail(goals.error());
  if (goals->empty()) co_return Result<>();
  Job job;
  for (const AxisTarget& goal : *goals) add_leg(job, goal, *speed, relative);
  co_return co_await begin(std::move(job));
}

Result<> VxmDriver::may_move_all(const std::vector<AxisTarget>& targets, bool relative) const {
  for (const AxisTarget& t : targets) {
    if (auto may = may_move(t.axis.index); !may) return may;
    if (relative && (t.value.value < -max_index || t.value.value > max_index))
      return fail(
          FaultKind::refused,
          fmt::format("{} steps are too many for one move: a VXM takes up to {}.", t.value.value, max_index),
          "Nothing was sent.");
  }
  return {};
}

/// Where each axis is to go, as far as positions are known. Axes that stay are left out.
Result<std::vector<AxisTarget>> VxmDriver::checked_goals(const std::vector<AxisTarget>& targets,
                                                         bool relative) {
  std::vector<AxisTarget> goals;
  for (const AxisTarget& t : targets) {
    const int axis = t.axis.index;
    const AxisState& state = draft_.axes[axis];
    const Steps goal = relative ? state.position + t.value : t.value;
    if ((!relative || state.position_known) &&
        (goal < console_.catalog.position_min || goal > console_.catalog.position_max))
      return fail(FaultKind::refused,
                  fmt::format("Position {} of motor {} lies outside the controller's register, {} to {}.",
                              goal.value, axis + 1, position_min, position_max),
                  "Nothing was sent.");
    if (relative && t.value.value == 0) continue;
    warn_of_motor_type(axis);
    goals.push_back({t.axis, goal});
  }
  return goals;
}

/// One leg after the other, but moves on the two controllers can run together; the Slave's must stand first
/// (App. G p.47).
void VxmDriver::add_leg(Job& job, const AxisTarget& goal, int speed, bool relative) const {
  const int axis = goal.axis.index;
  const Steps distance = goal.value - draft_.axes[axis].position;
  Leg* partner = job.legs.empty() ? nullptr : &job.legs.back();
  const bool pairs = partner && partner->second_axis < 0 && on_slave(partner->axis) != on_slave(axis);
  const Steps other = partner ? *partner->target - draft_.axes[partner->axis].position : Steps{};
  if (pairs && distance.value != 0 && other.value != 0) {
    partner->second_axis = axis;
    partner->text = on_slave(axis) ? index_pair(axis + 1, distance, partner->axis + 1, other)
                                   : index_pair(partner->axis + 1, other, axis + 1, distance);
    return;
  }
  Leg leg;
  leg.axis = axis;
  leg.activity = Activity::moving;
  leg.target = goal.value;
  leg.speed = speed;
  leg.sign = distance.value < 0 ? Sign::minus : Sign::plus;
  leg.text = relative ? index_by(axis + 1, distance) : index_to(axis + 1, goal.value);
  job.legs.push_back(std::move(leg));
}

VxmDriver::Leg VxmDriver::jog_leg(int axis, Sign sign, int speed) const {
  const AxisState& state = draft_.axes[axis];
  const Steps room = sign == Sign::plus ? console_.catalog.position_max - state.position
                                        : state.position - console_.catalog.position_min;
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

Task<Result<>> VxmDriver::jog(const intent::JogStart& wish) {
  const int axis = wish.axis.index;
  if (auto may = may_move(axis); !may) co_return may;
  auto speed = checked_speed(wish.speed.value == 0 ? console_.catalog.jog_speed : wish.speed);
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
  if (wish.mode < 0 || wish.mode >= static_cast<int>(console_.catalog.homing_modes.size()))
    co_return fail(FaultKind::refused, fmt::format("There is no way of homing number {}.", wish.mode),
                   "Nothing was sent.");
  if (parameters_.value("DM").value_or(0) & mode_nf90 && wish.sign == Sign::plus)
    co_return fail(FaultKind::refused,
                   fmt::format("In NF90 emulation I{}M0 runs to zero, not to the + limit switch.", axis + 1),
                   "Nothing was sent.",
                   "Switch NF90 emulation off in Parameters (DM), or home to the - limit switch.");
  warn_of_motor_type(axis);
  Leg to_switch;
  to_switch.axis = axis;
  to_switch.activity = Activity::homing;
  to_switch.sign = wish.sign;
  to_switch.speed = std::min(speeds_.usual(axis), homing_speed);
  to_switch.text = vxm::home(axis + 1, wish.sign);
  Leg zero;
  zero.axis = axis;
  zero.text = zero_here(axis + 1);
  zero.zeroes = Trust::homed;
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
    auto said = co_await talk_.say("N", Priority::intent);
    if (!said) co_return said;
    all_are_zero();
  } else {
    Leg leg;
    leg.axis = wish.axis;
    leg.text = zero_here(wish.axis + 1);
    leg.zeroes = Trust::set;
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

// What N leaves.
void VxmDriver::all_are_zero() {
  for (int i = 0; i < draft_.axis_count; ++i) draft_.axes[i].trust.settle(Trust::set, scheduler_.now());
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
  auto read = co_await signals_.read('$', Priority::intent);
  if (!read) co_return read;
  if (!nameplate_.tells_outputs()) co_return Result<>();  // nobody can tell
  const bool is_on = draft_.outputs >> (wish.number - 1) & 1;
  if (is_on == wish.on) co_return Result<>();
  co_return fail(FaultKind::controller,
                 fmt::format("Output {} was to go {}, but the controller says that it is {}.", wish.number,
                             wish.on ? "on" : "off", is_on ? "on" : "off"),
                 "It was asked for once.", "Look whether the Stop button is held, then try again.");
}

}  // namespace hw::vxm
