// Runs go from mark to mark (core/motion/course.h). Marks are switches, indexes, places of a contour, lost
// loads and turns of the track.
#include "core/devices/vme58/emulator_motion.h"

#include <algorithm>
#include <cmath>

namespace hw::vme58 {

using motion::Profile;
using What = MotionEvent::What;

namespace {

constexpr std::int64_t furthest_look = std::int64_t{1} << 40;  // counts: twelve days at full speed

Sign side_of(int way) { return way < 0 ? Sign::minus : Sign::plus; }

}  // namespace

Motion::Motion(const Variant& variant) {
  for (int a = 0; a < most_axes; ++a) axes_[ix(a)].fitting = variant.fitting(a);
  reset();
}

void Motion::reset() {
  board_ = BoardSettings();
  runs_ = {};
  events_.clear();
  update_at_.reset();
  for (int a = 0; a < most_axes; ++a) {
    MotionAxis& old = axes_[ix(a)];
    MotionAxis fresh;
    fresh.fitting = old.fitting, fresh.plant = old.plant;
    fresh.has_motor = old.has_motor, fresh.loop.plant = old.loop.plant;
    fresh.settings.holding = fresh.servo();
    fresh.span = old.span;
    fresh.reach();
    axes_[ix(a)] = fresh;
    axes_[ix(a)].set_encoder(0);
    changed(a);
  }
}

// --- time --------------------------------------------------------------------------------------------------

std::optional<Instant> Motion::next_event() const {
  std::optional<Instant> next = update_at_;
  const auto sooner = [&next](std::optional<Instant> t) {
    if (t && (!next || *t < *next)) next = t;
  };
  for (const Run& r : runs_) sooner(r.due());
  for (const MotionAxis& x : axes_) sooner(x.correct_at);
  return next;
}

void Motion::advance_to(Instant to) {
  now_ = to;
  bring_up_to_date();
  for (Run& r : runs_) {
    const auto when = r.due();
    if (!when || *when > now_) continue;
    if (r.applied >= r.next_mark) look(r);
    if (r.active) plan(r);
    if (r.active && r.has_arrived(now_)) finish(r, End::reached);
  }
  for (int a = 0; a < most_axes; ++a)
    if (axes_[ix(a)].correct_at && *axes_[ix(a)].correct_at <= now_) correct(a);
  if (update_at_ && *update_at_ <= now_) update_servos();
}

void Motion::take_events(std::vector<MotionEvent>& sink) {
  sink.insert(sink.end(), events_.begin(), events_.end());
  events_.clear();
}

void Motion::bring_up_to_date() {
  for (Run& r : runs_)
    if (r.active) apply(r, r.reached(now_));
}

void Motion::apply(Run& r, std::int64_t step) {
  r.make_steps(step, [this](int a, int way, std::int64_t count) { axes_[ix(a)].turn(way, count); });
}

// --- runs --------------------------------------------------------------------------------------------------

Run& Motion::free_run() {
  return *std::find_if(runs_.begin(), runs_.end(), [](const Run& r) { return !r.active; });
}

void Motion::begin(RunKind kind, unsigned axes, Track track, const Profile& profile, double wanted,
                   std::shared_ptr<const ContourPlan> contour_plan) {
  Run& r = free_run();
  r = Run();
  r.active = true, r.kind = kind, r.axes = axes;
  r.track = std::move(track), r.profile = profile, r.wanted = wanted, r.plan = std::move(contour_plan);
  for (int a = 0; a < most_axes; ++a) {
    if (!r.has(a)) continue;
    MotionAxis& x = axes_[ix(a)];
    x.run = static_cast<int>(&r - runs_.data());
    x.arrived_by = 0;
    x.correct_at.reset();
    x.loop.wake();
    if (const int way = r.track.direction(ix(a), 0); way != 0) x.direction = side_of(way);
  }
  look(r);
  for (int a = 0; r.active && a < most_axes; ++a)
    if (r.has(a) && !std::exchange(axes_[ix(a)].under_way, true)) note_event(What::began, a);
  if (r.active) plan(r);
  if (r.active && r.profile.end() <= now_) finish(r, End::reached);
  schedule_updates();
}

void Motion::continue_by(Run& r, const Profile& profile) {
  r.profile = profile;
  plan(r);
  if (profile.end() <= now_) finish(r, End::reached);
}

/// Handles what is due at the present step of the run. A new run is checked before its first count.
void Motion::look(Run& r) {
  if (r.plan && !follow_events(r)) return;
  for (int a = 0; a < most_axes; ++a) {
    if (!r.has(a)) continue;
    watch_error(a);
    if (!r.active) return;
    if (found_home(r, a) && !r.active) return;
    if (met_limit(r, a)) return;
    report_nearly_done(r, a);
    MotionAxis& x = axes_[ix(a)];
    if (x.passes && factor(x.direction) * (x.position - *x.passes) >= 0) {
      x.passes.reset();
      note_event(What::ready, a);
    }
  }
}

/// True: the run was cut or ramps down because of the limit.
bool Motion::met_limit(Run& r, int a) {
  MotionAxis& x = axes_[ix(a)];
  if (!x.settings.limits_on || (r.over_limit >> a & 1u) != 0) return false;
  for (const int way : {x.arrived_by, r.track.direction(ix(a), r.applied)}) {
    if (way == 0 || !x.plant.limit_operated(side_of(way))) continue;
    r.over_limit |= 1u << a;
    note_event(What::limit_hit, a, way > 0);
    const bool moves = r.applied > 0;  // a run that begins at the switch does not start
    if (x.settings.soft_limits && moves) {
      for (MotionAxis& each : axes_)
        if (each.run == x.run) each.then_jog.reset(), each.then_to.reset(), each.homing.reset();
      stop_run(r);
    } else {
      finish(r, End::cut);
    }
    return true;
  }
  return false;
}

std::optional<std::int64_t> Motion::counts_left(const Run& r, int a) const {
  if (r.kind == RunKind::contour) {
    for (const ContourEvent& event : r.plan->events)
      if (event.what == ContourEvent::What::end)
        return (std::max<std::int64_t>(event.step - r.applied, 0) + motion::Contour::steps_per_count - 1) /
               motion::Contour::steps_per_count;
  }
  if (r.kind != RunKind::move || r.stopping) return std::nullopt;
  return std::abs(r.track.offset(ix(a), r.track.steps()) - r.track.offset(ix(a), r.applied));
}

void Motion::report_nearly_done(Run& r, int a) {
  MotionAxis& x = axes_[ix(a)];
  const auto left = counts_left(r, a);
  if (!x.notify || !left || *left > *x.notify) return;
  x.notify.reset();
  note_event(What::nearly_done, a);
}

void Motion::plan(Run& r) {
  r.mark_turn();
  if (r.plan && r.event < r.plan->events.size()) {
    r.next_mark = std::min(r.next_mark, r.plan->events[r.event].step);
    for (const MotionAxis& x : axes_) {
      if (x.run < 0 || &runs_[ix(x.run)] != &r || !x.notify) continue;
      const std::int64_t step = r.plan->events.back().step - *x.notify * motion::Contour::steps_per_count;
      if (step > r.applied) r.next_mark = std::min(r.next_mark, step);
    }
  }
  for (int a = 0; a < most_axes; ++a)
    if (r.has(a)) plan_axis(r, a);
}

void Motion::plan_axis(Run& r, int a) {
  const int way = r.track.direction(ix(a), r.applied);
  if (way == 0) return;
  const MotionAxis& x = axes_[ix(a)];
  if (x.passes) r.mark(a, way, way * (*x.passes - x.position));
  if (x.notify && r.kind == RunKind::move)
    if (const auto left = counts_left(r, a)) r.mark(a, way, *left - *x.notify);
  if (x.has_motor) return;  // each update of the loop checks its load
  const Sign side = side_of(way);
  if (x.settings.limits_on && (r.over_limit >> a & 1u) == 0) r.mark(a, way, x.plant.turns_until_limit(side));
  if (x.homing) r.mark(a, way, x.counts_until_home(side));
  if (!x.watches_slip() || x.slipped) return;
  // Once the error grows it keeps growing, so the first count beyond the tolerance is found by bisection.
  const std::int64_t ahead =
      r.track.offset(ix(a), r.track.next_turn(r.applied)) - r.track.offset(ix(a), r.applied);
  std::int64_t low = 0, high = std::min(std::abs(ahead), furthest_look);
  const auto beyond = [&](std::int64_t counts) {
    return std::abs(x.error_after(way, counts)) > x.settings.slip_tolerance;
  };
  if (!beyond(high)) return;
  while (high - low > 1) (beyond(low + (high - low) / 2) ? high : low) = low + (high - low) / 2;
  r.mark(a, way, high);
}

void Motion::replan(int a) {
  if (Run* r = run_of(a)) {
    look(*r);
    if (r->active) plan(*r);
  } else {
    watch_error(a);
  }
}

void Motion::finish(Run& r, End end) {
  if (end == End::reached) apply(r, r.last_step());
  const unsigned axes = r.axes;
  r.active = false;
  r.plan.reset();
  for (int a = 0; a < most_axes; ++a) {
    if ((axes >> a & 1u) == 0) continue;
    MotionAxis& x = axes_[ix(a)];
    x.run = -1;
    x.homing.reset(), x.passes.reset(), x.goal.reset();
    if (end == End::cut) x.then_to.reset(), x.then_jog.reset();
  }
  for (int a = 0; a < most_axes; ++a)
    if ((axes >> a & 1u) != 0) rest(a);
}

/// The run of the axis has ended: starts what follows, or reports rest.
void Motion::rest(int a) {
  MotionAxis& x = axes_[ix(a)];
  if (const auto back = std::exchange(x.then_to, std::nullopt); back && back->position != x.position)
    return go_to(a, *back);
  if (const auto speed = std::exchange(x.then_jog, std::nullopt); speed && *speed != 0)
    return begin_endless(RunKind::jog, a, *speed < 0 ? Sign::minus : Sign::plus, std::abs(*speed));
  if (std::exchange(x.under_way, false)) note_event(What::rested, a);
  note_event(What::ready, a);
  watch_error(a);
}

// --- readings ----------------------------------------------------------------------------------------------

std::int64_t Motion::position(int a) const { return axes_[ix(a)].position; }

void Motion::measure_from_here() {
  for (MotionAxis& x : axes_) x.span = {x.position, x.position, 0};
}

std::int64_t Motion::encoder(int a) const { return axes_[ix(a)].encoder(); }
Sign Motion::direction(int a) const { return axes_[ix(a)].direction; }
bool Motion::moving(int a) const { return axes_[ix(a)].run >= 0; }

double Motion::velocity(int a) const {
  const Run* r = run_of(a);
  if (r == nullptr) return 0;
  return std::abs(r->track.slope(ix(a), r->profile.distance(now_))) * r->profile.speed(now_).value;
}

bool Motion::occupied(int a) const {
  const Run* r = run_of(a);
  if (r == nullptr) return false;
  const MotionAxis& x = axes_[ix(a)];
  switch (r->kind) {
    case RunKind::jog: return r->stopping && !x.then_jog;
    case RunKind::staircase: return r->stopping || x.passes.has_value();
    default: return true;
  }
}

bool Motion::in_position(int a) const {
  const MotionAxis& x = axes_[ix(a)];
  if (!x.fitting.encoder || !x.settings.holding) return true;
  return std::abs(x.error()) <= x.settings.hold_deadband;
}

bool Motion::limit_active(int a) const {
  const motion::Plant& plant = axes_[ix(a)].plant;
  return plant.limit_operated(Sign::plus) || plant.limit_operated(Sign::minus);
}

bool Motion::home_active(int a) const { return axes_[ix(a)].home_active(); }

bool Motion::encoder_home_active(int a) const {
  return axes_[ix(a)].home_active() && axes_[ix(a)].index_active();
}

}  // namespace hw::vme58
