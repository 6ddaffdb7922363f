// The commands that move: targets, lines, arcs, jogs, changes on the fly.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

using motion::Path;
using motion::Profile;
using motion::RampShape;

namespace {

bool in_range(std::int64_t v) { return v >= position_min && v <= position_max; }

RampOrder scaled(RampOrder r, double pulses_per_step) {
  r.top.value /= pulses_per_step;
  r.ramp.accel /= pulses_per_step, r.ramp.decel /= pulses_per_step;
  r.ramp.start_speed.value /= pulses_per_step;
  return r;
}

}  // namespace

SpeedOrder Controller::order(int axis) const {
  const auto own = [&](Setting id) { return settings_.get(id, axis); };
  SpeedOrder o;
  const bool individual = own(Setting::axis_high_speed) != 0 && own(Setting::axis_low_speed) != 0 &&
                          own(Setting::axis_accel) != 0;
  o.high = individual ? own(Setting::axis_high_speed) : settings_.get(Setting::high_speed);
  o.low = individual ? own(Setting::axis_low_speed) : settings_.get(Setting::low_speed);
  o.accel_ms = individual ? own(Setting::axis_accel) : settings_.get(Setting::accel);
  o.decel_ms = o.accel_ms;
  if (settings_.on(Setting::separate_decel)) {
    const bool own_decel = individual && own(Setting::axis_decel) != 0;
    o.decel_ms = own_decel ? own(Setting::axis_decel) : settings_.get(Setting::decel);
  }
  o.ratio = ratio(axis);
  o.shape = settings_.on(Setting::s_curve, axis) ? RampShape::s_curve : RampShape::linear;
  return o;
}

SpeedOrder Controller::path_order(unsigned axes) const {
  SpeedOrder o;
  o.high = settings_.get(Setting::high_speed), o.low = settings_.get(Setting::low_speed);
  o.accel_ms = o.decel_ms = settings_.get(Setting::accel);
  if (settings_.on(Setting::separate_decel)) o.decel_ms = settings_.get(Setting::decel);
  o.shape = RampShape::s_curve;
  for (int a = 0; a < this->axes(); ++a)
    if ((axes >> a & 1u) != 0 && !settings_.on(Setting::s_curve, a)) o.shape = RampShape::linear;
  return o;
}

RampOrder Controller::ramps_of(const Motion& m) const {
  return scaled(ramps(*model_, m.order), m.track.pulses_per_step());
}

/// STOP takes ACC (or DEC) from full speed, or from the present speed if that is higher.
RampOrder Controller::stop_ramps(const Motion& m) const {
  SpeedOrder o = m.order;
  const double now = m.profile.speed(now_).value * m.track.pulses_per_step() / o.ratio;
  o.high = std::max<std::int64_t>(o.high, std::llround(now));
  return scaled(ramps(*model_, o), m.track.pulses_per_step());
}

void Controller::begin_index(MotionKind kind, int a, std::int64_t pulses, const SpeedOrder& by) {
  Axis& axis = axes_[ix(a)];
  if (kind != MotionKind::correction) {
    axis.follows = closed(a);
    axis.anchor_target = axis.target, axis.anchor_offset = pulses;
  }
  if (pulses == 0) {
    axis.follows = false;
    if (kind == MotionKind::homing)
      home_stage_ended(a);
    else
      settle_loop(a);
    return;
  }
  const Path path = Path::along(ix(a), pulses < 0 ? Sign::minus : Sign::plus, std::abs(pulses));
  const RampOrder r = ramps_over(*model_, by, static_cast<double>(std::abs(pulses)));
  begin(kind, 1u << a, path, Profile::index(now_, path.steps(), r.top, r.ramp), by);
}

void Controller::begin_endless(MotionKind kind, int a, Sign way, bool slowly) {
  Axis& axis = axes_[ix(a)];
  axis.follows = closed(a);
  axis.anchor_target = axis.encoder(), axis.anchor_offset = 0;
  const Path path = Path::along(ix(a), way, Profile::endless);
  const SpeedOrder by = order(a);
  const RampOrder r = ramps(*model_, by);
  begin(kind, 1u << a, path,
        slowly ? Profile::constant(now_, 0, r.ramp.start_speed, Profile::endless)
               : Profile::index(now_, Profile::endless, r.top, r.ramp),
        by);
}

Refusal Controller::refuses_motion(unsigned wanted) const {
  const auto any = [&](auto&& holds) {
    for (int a = 0; a < axes(); ++a)
      if ((wanted >> a & 1u) != 0 && holds(a)) return true;
    return false;
  };
  const bool forgives = settings_.on(Setting::ignore_errors);
  if (any([&](int a) { return axes_[ix(a)].plus_error || axes_[ix(a)].minus_error; }))
    return Refusal::limit_error;
  if (any([&](int a) { return axes_[ix(a)].alarm_error || (!forgives && alarm_active(a)); }))
    return Refusal::alarm;
  if (any([&](int a) { return axes_[ix(a)].loop_error.has_value(); })) return Refusal::loop_error;
  if (any([&](int a) { return moving(a) || joystick_on(a); })) return Refusal::moving;
  return Refusal::none;
}

Refusal Controller::move(const Targets& targets) {
  bring_up_to_date();
  unsigned wanted = 0;
  int count = 0;
  std::array<std::int64_t, most_axes> goal{};
  for (int a = 0; a < axes(); ++a) {
    if (!targets[ix(a)]) continue;
    wanted |= 1u << a, ++count;
    const std::int64_t base = incremental_ ? position(a) : 0;
    goal[ix(a)] = base + *targets[ix(a)];
    if (!in_range(*targets[ix(a)]) || !in_range(goal[ix(a)])) return Refusal::unknown;
  }
  if (count == 0) return Refusal::unknown;
  if (const Refusal r = refuses_motion(wanted); r != Refusal::none) return r;

  motion::Offsets way{};
  int closed_loops = 0;
  for (int a = 0; a < axes(); ++a) {
    if (!targets[ix(a)]) continue;
    closed_loops += closed(a);
    const std::int64_t here = closed(a) ? encoder(a) : position(a);
    way[ix(a)] = std::llround(static_cast<double>(goal[ix(a)] - here) * ratio(a));
  }
  if (closed_loops != 0 && closed_loops != count) return Refusal::unknown;
  std::string sentence = "moves";
  for (int a = 0; a < axes(); ++a) {
    if (!targets[ix(a)]) continue;
    Axis& axis = axes_[ix(a)];
    axis.target = goal[ix(a)], axis.attempts = 0, axis.extra_done = false;
    axis.announces = true;
    sentence += " " + letter(a) + " to " + std::to_string(goal[ix(a)]);
    if (count == 1) {
      note_event(sentence, wanted);
      begin_index(MotionKind::target, a, way[ix(a)]);
      return Refusal::none;
    }
    axis.follows = closed(a);
    axis.anchor_target = goal[ix(a)], axis.anchor_offset = way[ix(a)];
  }
  note_event(sentence, wanted);
  const Path path = Path::line(way);
  const double length = static_cast<double>(path.steps()) * path.pulses_per_step();
  const SpeedOrder by = path_order(wanted);
  const RampOrder r = scaled(ramps_over(*model_, by, length), path.pulses_per_step());
  begin(MotionKind::interpolated, wanted, path, Profile::index(now_, path.steps(), r.top, r.ramp), by);
  return Refusal::none;
}

Refusal Controller::jog(int axis, Sign way) {
  bring_up_to_date();
  if (const Refusal r = refuses_motion(1u << axis); r != Refusal::none) return r;
  note_event("jogs " + letter(axis) + " " + hw::letter(way), 1u << axis);
  axes_[ix(axis)].announces = false, axes_[ix(axis)].attempts = 0, axes_[ix(axis)].extra_done = false;
  begin_endless(MotionKind::jog, axis, way, false);
  return Refusal::none;
}

/// The maker's angles begin on the minus X side of the centre and grow clockwise (decision AMB-063):
/// point = (cx - R cos a, cy + R sin a).
Refusal Controller::arc(std::int64_t centre_x, std::int64_t centre_y, bool clockwise,
                        std::optional<std::pair<std::int64_t, std::int64_t>> end_and_sweep) {
  constexpr double full = 2 * std::numbers::pi;
  bring_up_to_date();
  if (const Refusal r = refuses_motion(0b11); r != Refusal::none) return r;
  if (incremental_) return Refusal::incremental;
  if (closed(0) != closed(1) || ratio(0) != ratio(1)) return Refusal::unknown;
  const double k = ratio(0);
  const auto here = [&](int a) { return static_cast<double>(closed(a) ? encoder(a) : position(a)); };
  const double from_x = here(0) - static_cast<double>(centre_x);
  const double from_y = here(1) - static_cast<double>(centre_y);
  const double radius = std::hypot(from_x, from_y);
  if (radius < 0.5 || radius * k > static_cast<double>(max_radius)) return Refusal::unknown;

  double turn = full;
  if (end_and_sweep) {
    const double end = static_cast<double>(end_and_sweep->first % full_turn) / full_turn * full;
    const double start = std::atan2(from_y, -from_x);
    turn = std::fmod(clockwise ? end - start : start - end, full);
    if (turn < 0) turn += full;
    const double one_pulse = 1 / (radius * k);  // a smaller angle is the present place
    if (turn < one_pulse || full - turn < one_pulse) turn = end_and_sweep->second >= full_turn ? full : 0;
  }
  note_event("draws an arc about " + std::to_string(centre_x) + ", " + std::to_string(centre_y), 0b11);
  const Path path = Path::arc(0, 1, from_x * k, from_y * k, clockwise ? -turn : turn);
  for (int a = 0; a < 2; ++a) {
    Axis& axis = axes_[ix(a)];
    axis.attempts = 0, axis.extra_done = false, axis.follows = closed(a), axis.announces = true;
    axis.anchor_offset = turn == 0 ? 0 : path.offset(ix(a), path.steps());
    axis.anchor_target =
        (closed(a) ? encoder(a) : position(a)) + std::llround(static_cast<double>(axis.anchor_offset) / k);
  }
  if (turn == 0) return Refusal::none;
  const SpeedOrder by = path_order(0b11);
  const RampOrder r = scaled(ramps_over(*model_, by, radius * k * turn), path.pulses_per_step());
  begin(MotionKind::interpolated, 0b11, path, Profile::index(now_, path.steps(), r.top, r.ramp), by);
  return Refusal::none;
}

/// T: always an absolute destination (decision AMB-079).
Refusal Controller::change_target(int a, std::int64_t wanted) {
  bring_up_to_date();
  Motion* m = motion_of(a);
  Axis& axis = axes_[ix(a)];
  if (!in_range(wanted)) return Refusal::unknown;
  if (m == nullptr || m->kind != MotionKind::target || (m->stopping && !axis.then_target))
    return Refusal::not_targeted;
  note_event("goes on to " + letter(a) + " " + std::to_string(wanted), 1u << a);
  if (axis.then_target) {  // slowing down to turn round
    axis.then_target = wanted;
    return Refusal::none;
  }
  const int way = m->track.offset(ix(a), 1) < 0 ? -1 : 1;
  const std::int64_t old =
      closed(a) ? axis.anchor_target : wrap_position(axis.pulses + way * (m->track.steps() - m->applied));
  const std::int64_t steps =
      m->track.steps() + std::llround(static_cast<double>(way * (wanted - old)) * ratio(a));
  const RampOrder r = ramps_of(*m);
  const motion::Ramp slowing = stop_ramps(*m).ramp;  // SSPD may still be slowing it down
  const double from = m->profile.distance(now_);
  const Pps speed = m->profile.speed(now_);
  const Profile down = Profile::ramp_down(now_, from, speed, slowing);
  if (steps <= m->applied || steps < down.length()) {
    axis.then_target = wanted;
    m->stopping = true;
    m->track = Path::along(ix(a), way < 0 ? Sign::minus : Sign::plus, Profile::endless);
    continue_by(*m, down);
    return Refusal::none;
  }
  axis.target = axis.anchor_target = wanted;
  axis.anchor_offset = way * steps;
  m->track = Path::along(ix(a), way < 0 ? Sign::minus : Sign::plus, steps);
  continue_by(*m, Profile::approach(now_, from, speed, r.top, slowing.decel, r.ramp, steps));
  return Refusal::none;
}

/// SSPD: the change takes ACC (or, when slower and EDEC=1, DEC), decision AMB-059.
Refusal Controller::change_speed(int a, std::int64_t wanted) {
  bring_up_to_date();
  Motion* m = motion_of(a);
  const bool turns = m != nullptr && axes_[ix(a)].then_target.has_value();
  if (wanted < 1 || m == nullptr || (m->stopping && !turns) ||
      (m->kind != MotionKind::target && m->kind != MotionKind::jog))
    return Refusal::speed;
  const SpeedOrder o = order(a);
  const double now = m->profile.speed(now_).value, to = static_cast<double>(wanted) * o.ratio;
  SpeedOrder change = o;
  const auto unit = [&](double pulses) { return static_cast<std::int64_t>(std::llround(pulses / o.ratio)); };
  change.high = std::max(unit(now), wanted), change.low = std::min(unit(now), wanted);
  const std::int64_t ms = adjusted_ms(*model_, change, to < now ? o.decel_ms : o.accel_ms);
  const double rate = std::max(std::abs(to - now), 1.0) * 1000 / static_cast<double>(ms);
  m->order = o, m->order.high = wanted;
  const motion::Ramp after = ramps_of(*m).ramp;
  const motion::Ramp ramp(rate, after.decel, after.start_speed);
  const double from = m->profile.distance(now_);
  note_event("goes on with " + letter(a) + " at " + std::to_string(wanted));
  if (turns) return Refusal::none;  // the way back uses it
  if (m->kind == MotionKind::jog)
    continue_by(*m,
                Profile::change(now_, from, Pps(now), Pps(to), motion::Ramp(rate, rate), Profile::endless));
  else
    continue_by(*m, Profile::approach(now_, from, Pps(now), Pps(to), rate, ramp, m->track.steps()));
  return Refusal::none;
}

}  // namespace hw::arcus
