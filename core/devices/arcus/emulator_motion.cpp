// Motions run from mark to mark (core/motion/course.h). Marks are switches, indexes, sync positions, lost
// loads and turns of the path.
#include <algorithm>
#include <cmath>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

using motion::Path;
using motion::Profile;

namespace {

Sign sign_of(int way) { return way < 0 ? Sign::minus : Sign::plus; }

}  // namespace

void Controller::begin(MotionKind kind, unsigned axes, const Path& path, const Profile& profile,
                       const SpeedOrder& order) {
  int slot = 0;
  while ((axes >> slot & 1u) == 0) ++slot;
  Motion& m = motions_[ix(slot)];
  m = Motion();
  m.active = true, m.kind = kind, m.axes = axes, m.track = path, m.profile = profile;
  m.order = order;
  for (int a = 0; a < this->axes(); ++a) {
    Axis& axis = axes_[ix(a)];
    axis.moved_with = m.has(a) ? axes : axis.moved_with & ~axes;
    if (m.has(a)) axis.slot = slot, axis.arrived_by = 0;
  }
  ++moves_begun;
  look(m);
  if (m.active) plan(m);
  if (m.active && m.profile.end() <= now_) finish(m, End::reached);
}

void Controller::continue_by(Motion& m, const Profile& profile) {
  m.profile = profile;
  plan(m);
  if (profile.end() <= now_) finish(m, End::reached);
}

void Controller::bring_up_to_date() {
  for (Motion& m : motions_)
    if (m.active) apply(m, m.reached(now_));
}

void Controller::apply(Motion& m, std::int64_t step) {
  m.make_steps(step, [this](int a, int way, std::int64_t count) {
    axes_[ix(a)].turn(way, load_way(a, sign_of(way)), count);
  });
}

std::optional<Instant> Controller::next_event() const {
  if (!powered_) return std::nullopt;
  std::optional<Instant> next;
  const auto sooner = [&next](std::optional<Instant> t) {
    if (t && (!next || *t < *next)) next = t;
  };
  for (const Motion& m : motions_) sooner(m.due());
  for (const Axis& a : axes_)
    if (a.sync.open && a.sync.pulse_until > now_) sooner(a.sync.pulse_until);
  sooner(joystick_.due);
  sooner(timeout_.due());
  sooner(program_turn());
  return next;
}

void Controller::advance(Instant now) {
  now_ = now;
  if (!powered_) return;
  bring_up_to_date();
  for (Motion& m : motions_) {
    const auto when = m.due();
    if (!when || *when > now_) continue;
    if (m.applied >= m.next_mark) look(m);
    if (m.active) plan(m);
    if (m.active && m.has_arrived(now_)) finish(m, End::reached);
  }
  for (int a = 0; a < axes(); ++a) {
    const SyncOutput& s = axes_[ix(a)].sync;
    if (s.open && s.pulse_until > Instant{} && s.pulse_until <= now_) end_sync_pulse(a);
  }
  if (joystick_.due && *joystick_.due <= now_) joystick_tick();
  if (timeout_.comes(now_)) note_event("the host has been silent for longer than TOC");
  run_programs();
}

/// Does what is due at the motion's present step. A new motion is checked before its first pulse.
void Controller::look(Motion& m) {
  for (int a = 0; a < axes(); ++a) {
    if (!m.has(a)) continue;
    update_sync(a);
  }
  for (int a = 0; a < axes(); ++a) {
    if (!m.active || !m.has(a)) continue;
    const Axis& axis = axes_[ix(a)];
    const MotionKind kind = m.kind;
    const HomeStep step = axis.homing.step;
    if (hit_switch(m, a)) return;
    if (kind == MotionKind::homing && !m.stopping) {  // STOP ends homing
      home_looks(m, a);
      if (!m.active || axis.homing.step != step) return;
    }
    if (kind == MotionKind::joystick) {
      if (joystick_at_end(a)) return joystick_stops(a);
      schedule_joystick();
    }
    if (stalled(m, a)) return;
  }
}

void Controller::plan(Motion& m) {
  m.mark_turn();
  for (int a = 0; a < axes(); ++a)
    if (m.has(a)) plan_axis(m, a);
}

void Controller::plan_axis(Motion& m, int a) {
  const int way = m.track.direction(ix(a), m.applied);
  if (way == 0) return;
  const Axis& axis = axes_[ix(a)];
  const Sign side = sign_of(way), load = load_way(a, side);
  if (!limit_active(a, side)) {
    if (limits_inverted())
      m.mark(a, way, axis.plant.turns_until_limit_released(side, load));
    else if (side == load)
      m.mark(a, way, axis.plant.turns_until_limit(side));
  }
  if (m.kind == MotionKind::homing) watch_homing(m, a, way, load);
  if (m.kind == MotionKind::joystick)
    for (int limit = 0; limit < 4; ++limit)
      m.mark(a, way, way * (settings_.get(Setting::joystick_limits, 4 * a + limit) - axis.pulses));
  watch_loop(m, a, way, load);
  watch_sync(m, a, way, load);
}

void Controller::replan(int axis) {
  Motion* m = motion_of(axis);
  if (m == nullptr) return;
  look(*m);
  if (m->active) plan(*m);
}

/// A limit switch ahead, or the alarm: the motion ends here.
bool Controller::hit_switch(Motion& m, int a) {
  Axis& axis = axes_[ix(a)];
  const bool forgives = settings_.on(Setting::ignore_errors);
  const int ahead = m.track.direction(ix(a), m.applied);
  for (const int way : {axis.arrived_by, ahead}) {
    if (way == 0 || !limit_active(a, sign_of(way))) continue;
    if (!m.stopping && axis.homing.step == HomeStep::seek_switch && axis.homing.mode == HomeMode::limit)
      return false;
    note_event("axis " + letter(a) + " ran into its " + (way > 0 ? "plus" : "minus") + " limit switch",
               1u << a, way);
    if (!forgives) {
      (way > 0 ? axis.plus_error : axis.minus_error) = true;
      loop_fails(a, LoopState::limit_error);
    }
    cut(m);
    return true;
  }
  if (!alarm_active(a)) return false;
  note_event("axis " + letter(a) + " was stopped by its alarm input");
  if (!forgives) {
    axis.alarm_error = true;
    loop_fails(a, LoopState::limit_error);
  }
  cut(m);
  return true;
}

/// Ends a motion where it stands, without ramp.
void Controller::cut(Motion& m) {
  if (m.kind == MotionKind::buffered) {
    buffer_.queue.clear();
    buffer_.running = false;
  }
  for (int a = 0; a < axes(); ++a)
    if (m.has(a)) {
      axes_[ix(a)].then_target.reset();
      axes_[ix(a)].homing = Homing();
      if (m.kind == MotionKind::joystick) joystick_.speed[ix(a)] = 0;
    }
  m.stopping = true;
  finish(m, End::cut);
}

void Controller::finish(Motion& m, End end) {
  const Motion done = m;
  const bool reached = end == End::reached;
  if (reached) apply(m, m.last_step());
  for (int a = 0; a < axes(); ++a) {
    if (!done.has(a)) continue;
    freeze_target(a);
    axes_[ix(a)].slot = -1;
    axes_[ix(a)].rested_at = now_;
    update_sync(a);
  }
  m.active = false;
  if (end == End::halted) return;
  if (done.kind == MotionKind::buffered && reached) {
    segment_ended(Pps(done.profile.final_speed().value * done.track.pulses_per_step()));
    return;
  }
  for (int a = 0; a < axes(); ++a) {
    if (!done.has(a)) continue;
    Axis& axis = axes_[ix(a)];
    if (done.kind == MotionKind::homing && reached && !done.stopping && axis.homing.step != HomeStep::none) {
      home_stage_ended(a);
      continue;
    }
    if (done.stopping && !axis.then_target) axis.announces = false, axis.homing = Homing();
    if (done.by_hand) rest_here(a);
    if (const auto target = std::exchange(axis.then_target, std::nullopt)) {
      const double way =
          static_cast<double>(*target - (closed(a) ? axis.encoder() : wrap_position(axis.pulses)));
      const bool announces = axis.announces;
      axis.target = *target;
      begin_index(MotionKind::target, a, std::llround(way * ratio(a)), done.order);
      if (axis.slot >= 0) axis.announces = announces;
      continue;
    }
    settle_loop(a);
  }
}

// --- stopping ----------------------------------------------------------------------------------------------

void Controller::stop_motion(Motion& m) {
  for (int a = 0; a < axes(); ++a)
    if (m.has(a)) axes_[ix(a)].then_target.reset(), axes_[ix(a)].announces = false;
  if (m.kind == MotionKind::buffered && buffer_.queue.size() > 1) {
    buffer_.queue.resize(1);
    buffer_.end = buffer_.start;
  }
  m.stopping = true;
  if (std::exchange(m.by_hand, true)) return;  // STOP again changes nothing
  continue_by(m, m.ramp_within_track(now_, stop_ramps(m).ramp));
}

void Controller::stop(int axis) {
  bring_up_to_date();
  Motion* m = motion_of(axis);
  if (m == nullptr) return;
  if (m->kind == MotionKind::joystick) return joystick_stops(axis);
  stop_motion(*m);
}

void Controller::stop_all() {
  for (int a = 0; a < axes(); ++a) stop(a);
}

void Controller::abort(int axis) {
  bring_up_to_date();
  if (Motion* m = motion_of(axis)) {
    constexpr Duration one_update = std::chrono::milliseconds(1);
    for (int a = 0; a < axes(); ++a)
      if (m->has(a)) axes_[ix(a)].aborted_until = now_ + one_update;
    m->by_hand = true;
    cut(*m);
  }
  buffer_off();
}

void Controller::abort_all() {
  for (int a = 0; a < axes(); ++a) abort(a);
}

}  // namespace hw::arcus
