// StepNLoop (PMX manual ch. 6, DMX manual ch. 7; decisions AMB-097 to AMB-104). While an axis moves, its
// target runs with the pulses:
//
//   target(offset) = anchor_target + (offset - anchor_offset) / ratio
//
// so the position error is a function of the pulses made, and the pulse at which it gets too large is found
// before it comes.
#include <cmath>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

std::int64_t Controller::target_at(int a, std::int64_t offset) const {
  const Axis& axis = axes_[ix(a)];
  if (!axis.follows) return axis.target;
  return axis.anchor_target + std::llround(static_cast<double>(offset - axis.anchor_offset) / ratio(a));
}

std::int64_t Controller::target(int a) const {
  const Motion* m = motion_of(a);
  return m == nullptr ? axes_[ix(a)].target : target_at(a, m->track.offset(ix(a), m->applied));
}

void Controller::freeze_target(int a) {
  Axis& axis = axes_[ix(a)];
  axis.target = wrap_position(target(a));
  axis.follows = false;
}

std::int64_t Controller::loop_delta(int a) const {
  return closed(a) ? wrap_position(target(a) - axes_[ix(a)].encoder()) : 0;
}

void Controller::watch_loop(Motion& m, int a, int way, Sign load) {
  if (!closed(a)) return;
  const Axis& axis = axes_[ix(a)];
  const std::int64_t here = m.track.offset(ix(a), m.applied);
  const std::int64_t most = std::abs(m.track.offset(ix(a), m.track.next_turn(m.applied)) - here);
  const std::int64_t range = settings_.get(Setting::loop_range, a);
  m.mark(a, way, axis.first_turn(most, [&](std::int64_t turns) {
    const std::int64_t delta =
        target_at(a, here + way * turns) - axis.encoder_at(axis.plant.load_after(load, turns));
    return std::abs(delta) > range;
  }));
}

/// Too far behind while moving: state 10.
bool Controller::stalled(Motion& m, int a) {
  if (!closed(a) || std::abs(loop_delta(a)) <= settings_.get(Setting::loop_range, a)) return false;
  note_event("StepNLoop of axis " + letter(a) + " found a stall");
  loop_fails(a, LoopState::stall_error);
  cut(m);
  return true;
}

void Controller::loop_fails(int a, LoopState state) {
  if (!closed(a)) return;
  axes_[ix(a)].loop_error = state;
  axes_[ix(a)].announces = false;
}

/// After STOP and ABORT nothing is verified: only targeted moves that end by themselves are.
void Controller::rest_here(int a) {
  Axis& axis = axes_[ix(a)];
  if (!closed(a) || axis.loop_error) return;
  axis.target = wrap_position(axis.encoder());
  axis.attempts = 0, axis.extra_done = false;
}

/// At rest: in position, one more correction, or an error.
void Controller::settle_loop(int a) {
  Axis& axis = axes_[ix(a)];
  if (axis.slot >= 0) return;
  const auto arrived = [&] {
    if (std::exchange(axis.announces, false)) arrivals.push_back(a);
    axis.attempts = 0;
  };
  if (!closed(a)) return arrived();
  if (axis.loop_error) return;
  const std::int64_t delta = loop_delta(a), error = std::abs(delta);
  if (error > settings_.get(Setting::loop_range, a)) return loop_fails(a, LoopState::range_error);
  const bool in_position = error <= settings_.get(Setting::loop_tolerance, a);
  const bool idle_correction = in_position && axis.attempts > 0 && !axis.extra_done &&
                               settings_.has(Setting::loop_idle_tolerance) &&
                               error > settings_.get(Setting::loop_idle_tolerance, a);
  if (in_position && !idle_correction) return arrived();
  if (axis.attempts >= settings_.get(Setting::loop_attempts, a)) {
    if (in_position) return arrived();
    return loop_fails(a, LoopState::attempt_error);
  }
  // With IERR=1 a switch in the way ends the correction without an error: no other is tried.
  const Sign way = delta < 0 ? Sign::minus : Sign::plus;
  if (settings_.on(Setting::ignore_errors) && (limit_active(a, way) || alarm_active(a))) return;
  ++axis.attempts;
  axis.extra_done = idle_correction;
  const std::int64_t pulses = std::llround(static_cast<double>(delta) * ratio(a));
  begin_index(MotionKind::correction, a, pulses != 0 ? pulses : delta < 0 ? -1 : 1);
}

LoopState Controller::loop_state(int a) const {
  if (!closed(a)) return LoopState::off;
  const Axis& axis = axes_[ix(a)];
  if (axis.loop_error) return *axis.loop_error;
  const Motion* m = motion_of(a);
  if (m == nullptr) return now_ < axis.aborted_until ? LoopState::aborting : LoopState::idle;
  if (m->stopping && !axis.then_target) return LoopState::stopping;
  switch (m->kind) {
    case MotionKind::correction: return LoopState::correcting;
    case MotionKind::jog:
    case MotionKind::joystick: return LoopState::jogging;
    case MotionKind::homing:
      if (axis.homing.mode == HomeMode::limit) return LoopState::limit_homing;
      return axis.homing.step == HomeStep::seek_index ? LoopState::index_homing : LoopState::homing;
    default: return LoopState::moving;
  }
}

void Controller::clear_loop_error(int a) {
  Axis& axis = axes_[ix(a)];
  if (!axis.loop_error) return;
  axis.loop_error.reset();
  axis.attempts = 0;
  axis.target = wrap_position(axis.encoder());  // otherwise the range error would return at once (AMB-040)
}

void Controller::clear_errors(int a) {
  Axis& axis = axes_[ix(a)];
  axis.plus_error = axis.minus_error = axis.alarm_error = false;
  clear_loop_error(a);
  if (joystick_on(a)) schedule_joystick();
}

bool Controller::in_error(int a) const {
  const Axis& axis = axes_[ix(a)];
  return axis.plus_error || axis.minus_error || axis.alarm_error || axis.loop_error.has_value();
}

}  // namespace hw::arcus
