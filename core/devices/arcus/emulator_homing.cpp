// The five homing routines (PMX manual figures 6.5 to 6.9, DMX manual figures 7.2 to 7.6; decisions AMB-068
// to AMB-074). A model with a home correction (HCA) backs out of the switch by it at high speed; one without
// creeps out at low speed. A model with a limit correction (LCA) backs off the limit before it is at zero.
#include <cmath>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

using motion::Profile;

Refusal Controller::home(int a, HomeMode mode, Sign way) {
  bring_up_to_date();
  if (const Refusal r = refuses_motion(1u << a); r != Refusal::none) return r;
  note_event("homes " + letter(a) + " " + hw::letter(way), 1u << a);
  Axis& axis = axes_[ix(a)];
  axis.announces = false, axis.attempts = 0, axis.extra_done = false;
  axis.homing.mode = mode, axis.homing.way = way, axis.homing.seen = false;
  const bool index_only = mode == HomeMode::index;
  axis.homing.step = index_only ? HomeStep::seek_index : HomeStep::seek_switch;
  begin_endless(MotionKind::homing, a, way, index_only);
  return Refusal::none;
}

/// Zeroes both counters and the target; the motion continues and counts from here.
void Controller::zero(int a) {
  Axis& axis = axes_[ix(a)];
  counter_is_written(a);
  axis.pulses = 0;
  axis.set_encoder(0);
  axis.target = axis.anchor_target = 0;
  if (const Motion* m = motion_of(a)) axis.anchor_offset = m->track.offset(ix(a), m->applied);
}

void Controller::watch_homing(Motion& m, int a, int way, Sign load) {
  const Axis& axis = axes_[ix(a)];
  const auto until_home = [&](bool active) {
    const bool operated = active != inverted(model_->polarity.home, a);
    m.mark(a, way, operated ? axis.plant.turns_until_home(load) : axis.plant.turns_until_home_released(load));
  };
  switch (axis.homing.step) {
    case HomeStep::seek_switch:
      if (axis.homing.mode != HomeMode::limit) until_home(true);
      break;
    case HomeStep::back_out: until_home(!axis.homing.seen); break;
    case HomeStep::approach: until_home(true); break;
    case HomeStep::seek_index: m.mark(a, way, axis.turns_until_index(load)); break;
    default: break;
  }
}

void Controller::home_looks(Motion& m, int a) {
  Axis& axis = axes_[ix(a)];
  const Homing homing = axis.homing;
  switch (homing.step) {
    case HomeStep::seek_switch:
      if (homing.mode == HomeMode::limit ? limit_active(a, homing.way) : home_active(a))
        home_switch_found(m, a);
      break;
    case HomeStep::seek_index:
      if (axis.arrived_by == 0 || !axis.index_operated()) break;
      finish(m, End::halted);
      zero(a);
      home_done(a);
      break;
    case HomeStep::back_out:
      if (home_active(a)) {
        axis.homing.seen = true;
      } else if (homing.seen && settings_.has(Setting::home_correction)) {
        const auto further = static_cast<double>(settings_.get(Setting::home_correction)) * ratio(a);
        axis.homing.step = HomeStep::past;
        const RampOrder r = ramps_of(m);
        const double from = m.profile.distance(now_);
        const Pps speed = m.profile.speed(now_);
        continue_by(m, Profile::approach(now_, from, speed, r.top, r.ramp.decel, r.ramp,
                                         m.applied + std::llround(further)));
      } else if (homing.seen) {
        finish(m, End::halted);
        axis.homing.step = HomeStep::approach;
        begin_endless(MotionKind::homing, a, homing.way, true);
      }
      break;
    case HomeStep::approach:
      if (!home_active(a)) break;
      finish(m, End::halted);
      zero(a);
      home_done(a);
      break;
    default: break;
  }
}

void Controller::home_switch_found(Motion& m, int a) {
  Axis& axis = axes_[ix(a)];
  const Homing homing = axis.homing;
  if (homing.mode != HomeMode::limit) {
    if (homing.mode != HomeMode::home_index) zero(a);
    axis.homing.step = HomeStep::slow_down;
    const double from = m.profile.distance(now_);
    const Pps speed = m.profile.speed(now_);
    continue_by(m, Profile::ramp_down(now_, from, speed, ramps_of(m).ramp));
    return;
  }
  finish(m, End::halted);
  if (!settings_.has(Setting::limit_correction)) {
    zero(a);
    return home_done(a);
  }
  axis.homing.step = HomeStep::back_off;
  const std::int64_t back = -factor(homing.way) * settings_.get(Setting::limit_correction);
  axis.target = axis.encoder() + back;
  begin_index(MotionKind::homing, a, std::llround(static_cast<double>(back) * ratio(a)));
}

void Controller::home_stage_ended(int a) {
  Axis& axis = axes_[ix(a)];
  Homing& homing = axis.homing;
  switch (homing.step) {
    case HomeStep::slow_down:
      if (homing.mode == HomeMode::home) return home_done(a);
      if (homing.mode == HomeMode::home_index) {
        homing.step = HomeStep::seek_index;
        return begin_endless(MotionKind::homing, a, homing.way, true);
      }
      homing.step = HomeStep::back_out;
      homing.seen = home_active(a);
      return begin_endless(MotionKind::homing, a, -homing.way, !settings_.has(Setting::home_correction));
    case HomeStep::past:
      homing.step = HomeStep::approach;
      return begin_endless(MotionKind::homing, a, homing.way, true);
    case HomeStep::back_off: zero(a); return home_done(a);
    default: return home_done(a);
  }
}

void Controller::home_done(int a) {
  Axis& axis = axes_[ix(a)];
  const Homing homing = axis.homing;
  const bool returns = settings_.on(Setting::return_to_zero) && homing.step != HomeStep::return_zero &&
                       (homing.mode == HomeMode::home || homing.mode == HomeMode::home_high_low);
  if (returns) {
    axis.homing.step = HomeStep::return_zero;
    axis.target = 0;
    const std::int64_t here = closed(a) ? axis.encoder() : axis.pulses;
    return begin_index(MotionKind::homing, a, -std::llround(static_cast<double>(here) * ratio(a)));
  }
  note_event("axis " + letter(a) + " is homed");
  axis.homing = Homing();
  settle_loop(a);
}

}  // namespace hw::arcus
