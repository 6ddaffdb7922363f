#include "core/devices/vxm/moves.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "core/device/homing.h"
#include "core/device/target_check.h"
#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr int off_switch_steps = 4000;  // way off a home switch before the second approach (App. N p.67)
constexpr int homing_speed = hard_stop_safe_speed;  // the manual's limit for reliable homing (p.27)

bool on_slave(int axis) { return axis >= motors_per_controller; }

Result<LegPace> checked(const Catalog& catalog, const intent::Pace& requested) {
  const auto pace = check_pace(catalog, acceleration_unit, requested);
  if (!pace) return fail(pace.error());
  return LegPace{static_cast<int>(pace->speed), static_cast<int>(pace->acceleration)};
}

intent::Pace with_speed(intent::Pace pace, Pps own) {
  if (own.value > 0) pace.speed = own;
  return pace;
}

}  // namespace

Task<Result<>> Moves::move(const std::vector<AxisTarget>& targets, intent::Pace request,
                           const intent::AxisSpeeds& own, bool relative) {
  std::array<LegPace, max_axes> paces{};
  for (const AxisTarget& target : targets) {
    if (target.axis.index >= max_axes) continue;  // refused below
    const auto pace = checked(console_.catalog, with_speed(request, own[target.axis.index]));
    if (!pace) co_return fail(pace.error());
    paces[target.axis.index] = *pace;
  }
  // Reads the positions first: the last round may have asked before a program ended.
  if (auto may = may_move_all(targets, relative); !may) co_return may;
  auto read = co_await positions_.read(Priority::intent, true);
  if (!read) co_return read;
  auto goals = checked_goals(targets, relative);
  if (!goals) co_return fail(goals.error());
  if (goals->empty()) co_return Result<>();
  Job job;
  for (const AxisTarget& goal : *goals) add_leg(job, goal, paces[goal.axis.index], relative);
  co_return co_await legs_.begin(std::move(job));
}

Result<> Moves::may_move_all(const std::vector<AxisTarget>& targets, bool relative) const {
  for (const AxisTarget& t : targets) {
    if (auto may = admission_.may_move(t.axis.index); !may) return may;
    if (relative && (t.value.value < -max_index || t.value.value > max_index))
      return fail(
          FaultKind::refused,
          fmt::format("{} steps are too many for one move: a VXM takes up to {}.", t.value.value, max_index),
          "Nothing was sent.");
  }
  return {};
}

/// The goal of each axis, as far as positions are known. Axes that stay are left out.
Result<std::vector<AxisTarget>> Moves::checked_goals(const std::vector<AxisTarget>& targets, bool relative) {
  std::vector<AxisTarget> goals;
  for (const AxisTarget& t : targets) {
    const int axis = t.axis.index;
    const AxisState& state = console_.snapshot.axes[axis];
    const Steps goal = relative ? state.position + t.value : t.value;
    if (!relative || state.position_known)
      if (auto reached = check_target(console_.catalog, t.axis, Steps(0), goal); !reached)
        return fail(reached.error());
    if (relative && t.value.value == 0) continue;
    admission_.warn_of_motor_type(axis);
    goals.push_back({t.axis, goal});
  }
  return goals;
}

/// Legs run one after the other, but moves on the two controllers can be paired; the Slave's must be written
/// first (App. G p.47).
void Moves::add_leg(Job& job, const AxisTarget& goal, LegPace pace, bool relative) const {
  const int axis = goal.axis.index;
  const Steps distance = goal.value - console_.snapshot.axes[axis].position;
  Leg* partner = job.last();
  const bool pairs = partner && partner->second_axis < 0 && on_slave(partner->axis) != on_slave(axis) &&
                     partner->pace == pace;
  const Steps other = partner ? *partner->target - console_.snapshot.axes[partner->axis].position : Steps{};
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
  leg.pace = pace;
  leg.sign = distance.value < 0 ? Sign::minus : Sign::plus;
  leg.text = relative ? index_by(axis + 1, distance) : index_to(axis + 1, goal.value);
  job.add(std::move(leg));
}

Task<Result<>> Moves::jog(const intent::JogStart& request) {
  const int axis = request.axis.index;
  if (auto may = admission_.may_move(axis); !may) co_return may;
  intent::Pace wanted = pace_of(request);
  if (wanted.speed.value == 0) wanted.speed = console_.catalog.jog_speed;
  auto pace = checked(console_.catalog, wanted);
  if (!pace) co_return fail(pace.error());
  if (request.up_to) {
    auto read = co_await positions_.read(Priority::intent, true);
    if (!read) co_return read;
  }
  admission_.warn_of_motor_type(axis);
  Job job = Job::jog(legs_.jog_leg(axis, request.sign, *pace, request.up_to));
  if (*job.leg().target == console_.snapshot.axes[axis].position && request.up_to)
    co_return fail(FaultKind::refused,
                   fmt::format("Motor {} is at the end of its travel, {}.", axis + 1, request.up_to->value),
                   "Nothing was sent.", "Jog it the other way, or change the limit.");
  if (*job.leg().target == console_.snapshot.axes[axis].position)
    co_return fail(FaultKind::refused,
                   fmt::format("Motor {} is at the end of the controller's position register.", axis + 1),
                   "Nothing was sent.", "Set its position to zero first.");
  co_return co_await legs_.begin(std::move(job));
}

Task<Result<>> Moves::home(const intent::Home& request) {
  const int axis = request.axis.index;
  if (auto may = admission_.may_move(axis); !may) co_return may;
  if (auto may = check_home(console_.catalog, request); !may) co_return may;
  if (parameters_.value("DM").value_or(0) & mode_nf90 && request.sign == Sign::plus)
    co_return fail(FaultKind::refused,
                   fmt::format("In NF90 emulation I{}M0 runs to zero, not to the + limit switch.", axis + 1),
                   "Nothing was sent.",
                   "Switch NF90 emulation off in Setup (DM), or home to the - limit switch.");
  auto pace = checked(console_.catalog, request.pace);
  if (!pace) co_return fail(pace.error());
  if (pace->speed > homing_speed)
    co_return fail(FaultKind::refused,
                   fmt::format("{} steps/s is too fast for homing: a VXM finds a switch reliably up to {} "
                               "steps/s.",
                               pace->speed, homing_speed),
                   "Nothing was sent.");
  if (pace->speed == 0) pace->speed = std::min(speeds_.speed.usual(axis), homing_speed);
  admission_.warn_of_motor_type(axis);
  Leg to_switch;
  to_switch.axis = axis;
  to_switch.activity = Activity::homing;
  to_switch.sign = request.sign;
  to_switch.pace = *pace;
  to_switch.text = vxm::home(axis + 1, request.sign);
  to_switch.to_switch = true;
  Leg zero;
  zero.axis = axis;
  zero.text = zero_here(axis + 1);
  zero.zeroes = Trust::homed;
  Leg off_switch = to_switch;
  off_switch.sign = -request.sign;
  off_switch.to_switch = false;
  off_switch.text = index_by(axis + 1, Steps{factor(off_switch.sign) * off_switch_steps});
  Job job;
  job.add(to_switch);
  if (request.mode == 2) {  // Appendix N p.67: always the same direction at the end
    job.add(off_switch);
    job.add(to_switch);
  }
  if (request.mode != 0) job.add(zero);
  co_return co_await legs_.begin(std::move(job));
}

Task<Result<>> Moves::set_position(const intent::SetPosition& request) {
  if (request.value.value != 0)
    co_return fail(
        FaultKind::refused,
        fmt::format("A VXM can set the present position only to zero, not to {}.", request.value.value),
        "Nothing was sent.", "Set zero here, or first move to the place of the new zero.");
  if (auto may = request.axis < 0 ? admission_.may_run() : admission_.may_move(request.axis); !may)
    co_return may;
  if (request.axis < 0) {
    auto sent = co_await conversation_.transmit("N", Priority::intent);
    if (!sent) co_return sent;
    positions_.are_zero();
  } else {
    Leg leg;
    leg.axis = request.axis;
    leg.text = zero_here(request.axis + 1);
    leg.zeroes = Trust::set;
    auto done = co_await legs_.run_quickly(std::move(leg));
    if (!done) co_return done;
  }
  auto read = co_await positions_.read(Priority::intent, true);
  if (!read) co_return read;
  for (int i = 0; i < console_.snapshot.axis_count; ++i)
    if ((request.axis < 0 || request.axis == i) && console_.snapshot.axes[i].enabled &&
        console_.snapshot.axes[i].position.value != 0)
      co_return fail(FaultKind::controller,
                     fmt::format("Motor {} was set to zero, but the controller reports {}.", i + 1,
                                 console_.snapshot.axes[i].position.value),
                     "Its position is unchanged.", "Check whether the Stop button is held, then try again.");
  co_return Result<>();
}

// U4, U5 and the like are stored commands: they need a run too.
Task<Result<>> Moves::set_output(const intent::SetOutput& request) {
  if (request.number < 1 || request.number > outputs_per_controller)
    co_return fail(FaultKind::refused,
                   fmt::format("There is no output {}: a VXM has outputs 1 to 4.", request.number),
                   "Nothing was sent.");
  if (auto may = admission_.may_run(); !may) co_return may;
  Leg leg;
  leg.text = output(request.number, request.on);
  auto done = co_await legs_.run_quickly(std::move(leg));
  if (!done) co_return done;
  auto read = co_await signals_.read("$", Priority::intent);
  if (!read) co_return read;
  if (!identification_.reports_outputs()) co_return Result<>();  // the outputs are not reported
  const bool is_on = console_.snapshot.outputs >> (request.number - 1) & 1;
  if (is_on == request.on) co_return Result<>();
  co_return fail(FaultKind::controller,
                 fmt::format("Output {} was switched {}, but the controller reports {}.", request.number,
                             request.on ? "on" : "off", is_on ? "on" : "off"),
                 "It was sent once.", "Check whether the Stop button is held, then try again.");
}

}  // namespace hw::vxm
