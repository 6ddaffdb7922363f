// Moves, jogs, staircases, and how they end.
#include <algorithm>
#include <cmath>

#include "core/devices/vme58/emulator_motion.h"

namespace hw::vme58 {

using motion::Path;
using motion::Profile;
using motion::Ramp;
using motion::RampShape;

namespace {

constexpr double least_acceleration = 1e-3;  // AC0 is allowed: taken as a very low rate

bool in_range(std::int64_t position) { return std::abs(position) <= position_max; }

Sign sign_of(double v) { return v < 0 ? Sign::minus : Sign::plus; }

Path way_along(int axis, Sign way, std::int64_t length) { return Path::along(ix(axis), way, length); }

/// CN, PN, PF shape the ramps of all axes (decision M45).
Ramp shaped(double acceleration, double base, double top, const BoardSettings& board) {
  const double rate = std::max(acceleration, least_acceleration);
  constexpr double cut = 0.95;  // a full parabola would never reach its top
  RampShape shape = RampShape::linear;
  if (board.ramp == RampForm::cosine) shape = RampShape::half_cosine;
  if (board.ramp == RampForm::parabolic) shape = RampShape::parabolic;
  Ramp ramp(rate, rate, Pps(base), shape);
  ramp.truncation = std::min(board.truncation / 10.0, cut);
  ramp.top = Pps(top);
  return ramp;
}

}  // namespace

Ramp Motion::ramp_of(int axis) const {
  const AxisSettings& s = settings(axis);
  return shaped(s.acceleration, s.base_velocity, s.velocity, board_);
}

/// The ramp of a line is that of its longest axis (decision M48), of a contour the gentlest of its axes
/// (decision M76).
Ramp Motion::ramp_of(const Run& r) const {
  int lead = -1;
  double rate = acceleration_max, base = velocity_max;
  std::int64_t longest = -1;
  for (int a = 0; a < most_axes; ++a) {
    if (!r.has(a)) continue;
    const std::int64_t way = r.alone() ? 0 : std::abs(r.track.offset(ix(a), r.track.steps()));
    if (way > longest) longest = way, lead = a;
    rate = std::min(rate, settings(a).acceleration), base = std::min(base, settings(a).base_velocity);
  }
  if (r.kind != RunKind::contour) return ramp_of(lead);
  constexpr auto fine = static_cast<double>(motion::Contour::steps_per_count);
  return shaped(rate * fine, base * fine, board_.contour_velocity * fine, board_);
}

bool Motion::start(const Move& move) {
  bring_up_to_date();
  motion::Offsets way{};
  int lead = -1;
  for (int a = 0; a < most_axes; ++a) {
    if (!move.goal[ix(a)]) continue;
    const MotionAxis& x = axes_[ix(a)];
    // A jog ends only by ST or JG0 (decision M61).
    if (x.off() || x.run >= 0) return false;
    const AxisGoal& goal = *move.goal[ix(a)];
    const std::int64_t target = goal.relative ? x.position + goal.counts : goal.counts;
    if (!in_range(target)) return false;
    way[ix(a)] = target - x.position;
    if (lead < 0 || std::abs(way[ix(a)]) > std::abs(way[ix(lead)])) lead = a;
  }
  if (lead < 0 || way[ix(lead)] == 0) return true;
  const unsigned axes = move.axes();
  if (axes == 1u << lead && !move.goal[ix(lead)]->relative)
    axes_[ix(lead)].goal = move.goal[ix(lead)]->counts;
  const Path path = Path::line(way);
  begin(RunKind::move, axes, Track(path),
        Profile::index(now_, path.steps(), Pps(settings(lead).velocity), ramp_of(lead)),
        settings(lead).velocity);
  return true;
}

void Motion::go_to(int a, const Return& goal) {
  MotionAxis& x = axes_[ix(a)];
  x.goal = goal.position;
  const std::int64_t way = goal.position - x.position;
  const Path path = way_along(a, way < 0 ? Sign::minus : Sign::plus, std::abs(way));
  begin(RunKind::move, 1u << a, Track(path), Profile::index(now_, path.steps(), Pps(goal.speed), ramp_of(a)),
        goal.speed);
}

void Motion::begin_endless(RunKind kind, int a, Sign way, double speed) {
  begin(kind, 1u << a, Track(way_along(a, way, Profile::endless)),
        Profile::index(now_, Profile::endless, Pps(speed), ramp_of(a)), speed);
}

bool Motion::jog(int a, double velocity) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  if (x.off()) return false;
  Run* r = run_of(a);
  if (r == nullptr) {
    if (velocity != 0) begin_endless(RunKind::jog, a, sign_of(velocity), std::abs(velocity));
    return true;
  }
  if (r->kind != RunKind::jog && r->kind != RunKind::staircase) return false;
  r->kind = RunKind::jog;
  x.passes.reset(), x.then_jog.reset();
  const double from = r->profile.distance(now_);
  const Pps now = r->profile.speed(now_);
  if (velocity != 0 && sign_of(velocity) == sign_of(r->track.direction(ix(a), r->applied))) {
    r->stopping = false;
    r->wanted = std::abs(velocity);
    continue_by(*r, Profile::change(now_, from, now, Pps(r->wanted), ramp_of(a), Profile::endless));
    return true;
  }
  if (velocity != 0) x.then_jog = velocity;
  stop_run(*r);
  return true;
}

// --- staircase (decision M84) ------------------------------------------------------------------------------

void Motion::set_direction(int a, Sign way) { axes_[ix(a)].direction = way; }

bool Motion::move_velocity(int a, std::int64_t position, double velocity) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  Run* r = run_of(a);
  if (x.off() || !in_range(position) || velocity <= 0) return false;
  if (factor(x.direction) * (position - x.position) <= 0) return false;
  if (r == nullptr) {
    x.passes = position;
    begin_endless(RunKind::staircase, a, x.direction, velocity);
    return true;
  }
  if (r->stopping || (r->kind != RunKind::jog && r->kind != RunKind::staircase)) return false;
  if (r->track.direction(ix(a), r->applied) != factor(x.direction)) return false;
  x.passes = position;
  r->kind = RunKind::staircase;
  r->wanted = velocity;
  continue_by(*r, Profile::change(now_, r->profile.distance(now_), r->profile.speed(now_), Pps(velocity),
                                  ramp_of(a), Profile::endless));
  return true;
}

/// Lets the run end `counts` counts further on, at `speed` as far as the distance permits.
void Motion::run_to(Run& r, int a, std::int64_t counts, double speed) {
  const Sign way = r.track.direction(ix(a), r.applied) < 0 ? Sign::minus : Sign::plus;
  const std::int64_t end = r.applied + counts;
  r.track = Track(way_along(a, way, end));
  r.kind = RunKind::move;
  r.stopping = false;
  r.wanted = speed;
  const Ramp ramp = ramp_of(a);
  continue_by(r, Profile::approach(now_, r.profile.distance(now_), r.profile.speed(now_), Pps(speed),
                                   ramp.decel, ramp, end));
}

bool Motion::stop_at(int a, std::int64_t position) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  Run* r = run_of(a);
  if (r == nullptr) return position == x.position;
  if (r->kind != RunKind::jog && r->kind != RunKind::staircase) return false;
  const bool turns = r->stopping && x.then_jog;  // a jog the other way follows
  if ((r->stopping && !turns) || !in_range(position)) return false;
  x.passes.reset();
  const double speed = turns ? std::abs(*std::exchange(x.then_jog, std::nullopt)) : r->wanted;
  const std::int64_t left = r->track.direction(ix(a), r->applied) * (position - x.position);
  if (turns || left < 0) {
    turn_back(*r, a, {position, speed});
  } else {
    x.goal = position;
    run_to(*r, a, left, speed);
  }
  return true;
}

/// Ramps to rest, then goes to `goal`.
void Motion::turn_back(Run& r, int a, const Return& goal) {
  axes_[ix(a)].then_to = goal;
  stop_run(r);
}

bool Motion::ends(const Run& r, int a) const {
  return r.stopping && !axes_[ix(a)].then_jog && !axes_[ix(a)].then_to;
}

bool Motion::force_position(int a, std::int64_t position) {
  bring_up_to_date();
  if (!in_range(position)) return false;
  MotionAxis& x = axes_[ix(a)];
  Run* r = run_of(a);
  if (r == nullptr || ends(*r, a)) return true;
  x.then_jog.reset(), x.then_to.reset();
  const double cruise = std::abs(r->track.slope(ix(a), r->profile.distance(now_))) * r->wanted;
  if (r->alone() && r->kind != RunKind::contour) {
    x.homing.reset(), x.passes.reset();
  } else {
    leave(*r, a);
    r = run_of(a);
  }
  if (r == nullptr) return true;
  const int way = r->track.direction(ix(a), r->applied);
  const double from = r->profile.distance(now_);
  const Pps speed = r->profile.speed(now_);
  const std::int64_t left = way * (position - x.position);
  if (r->applied + left < Profile::ramp_down(now_, from, speed, ramp_of(a)).length()) {
    stop_run(*r);
    return true;
  }
  x.goal = position;
  run_to(*r, a, left, cruise);
  return true;
}

// --- ends --------------------------------------------------------------------------------------------------

void Motion::stop_run(Run& r) {
  if (std::exchange(r.stopping, true)) return;
  const Ramp ramp = ramp_of(r);
  const Pps speed = r.profile.speed(now_);
  // Below one pulse per second an axis stands between two pulses: no further pulse follows a stop.
  if (speed.value < 1) return finish(r, End::rests);
  const bool on_contour = r.kind == RunKind::contour;
  continue_by(r, on_contour ? Profile::ramp_down(now_, r.profile.distance(now_), speed, ramp)
                            : r.ramp_within_track(now_, ramp));
}

/// All axes of a line or a contour ramp down together, along their path.
void Motion::stop(int a) {
  bring_up_to_date();
  Run* r = run_of(a);
  if (r == nullptr) return;
  for (MotionAxis& x : axes_)
    if (x.run == axes_[ix(a)].run) x.then_jog.reset(), x.then_to.reset(), x.homing.reset();
  stop_run(*r);
}

void Motion::kill(int a) {
  bring_up_to_date();
  if (Run* r = run_of(a)) finish(*r, End::cut);
}

/// The axis leaves the run and goes on by itself, endlessly, at its present speed.
void Motion::leave(Run& r, int a) {
  const double speed = velocity(a);
  const int way = r.track.direction(ix(a), r.applied);
  MotionAxis& x = axes_[ix(a)];
  x.homing.reset(), x.goal.reset(), x.passes.reset();
  if (speed <= 0 || way == 0) {
    if (r.alone()) return finish(r, End::cut);
    r.axes &= ~(1u << a);
    x.run = -1;
    return rest(a);
  }
  // Keeps the fraction of a count already made.
  const double part = way * (r.track.exact(ix(a), r.profile.distance(now_)) -
                             static_cast<double>(r.track.offset(ix(a), r.applied)));
  r.axes &= ~(1u << a);
  if (r.axes == 0) r.active = false;
  Run& own = free_run();
  own = Run();
  own.active = true, own.kind = RunKind::jog, own.axes = 1u << a;
  own.track = Track(way_along(a, way < 0 ? Sign::minus : Sign::plus, Profile::endless));
  own.wanted = speed;
  x.run = static_cast<int>(&own - runs_.data());
  continue_by(own, Profile::constant(now_, std::clamp(part, 0.0, 0.999), Pps(speed), Profile::endless));
}

/// A ramp to rest goes on: a stop is not undone.
void Motion::keep_velocity(int a) {
  bring_up_to_date();
  Run* r = run_of(a);
  if (r == nullptr || ends(*r, a)) return;
  axes_[ix(a)].then_jog.reset(), axes_[ix(a)].then_to.reset();
  leave(*r, a);
}

// --- counters ----------------------------------------------------------------------------------------------

void Motion::load_position(int a, std::int64_t position) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  const std::int64_t by = position - x.position;
  x.set_position(position);
  if (x.servo() && x.settings.holding)
    x.zero += by;  // LP leaves the loop's error as it is
  else
    x.set_encoder(x.expected(position));
  Run* r = run_of(a);
  if (r != nullptr && x.goal && r->alone()) aim_again(*r, a);
  replan(a);
}

/// The target of an absolute move is kept, so the distance to it has changed (decision M92).
void Motion::aim_again(Run& r, int a) {
  MotionAxis& x = axes_[ix(a)];
  if (x.then_to || r.stopping) return;
  const std::int64_t left = r.track.direction(ix(a), r.applied) * (*x.goal - x.position);
  const std::int64_t end = r.applied + left;
  const Profile down = Profile::ramp_down(now_, r.profile.distance(now_), r.profile.speed(now_), ramp_of(a));
  if (left > 0 && end >= down.length()) return run_to(r, a, left, r.wanted);
  r.track = Track(
      way_along(a, r.track.direction(ix(a), r.applied) < 0 ? Sign::minus : Sign::plus, Profile::endless));
  turn_back(r, a, {*x.goal, r.wanted});
}

void Motion::remainder(int a, std::int64_t divisor) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  const std::int64_t by = x.position % divisor - x.position;
  const std::int64_t encoder = x.encoder(), wanted = x.expected(x.position + by) - x.expected(x.position);
  x.set_position(x.position + by);
  // Position holding must not see a false error.
  x.set_encoder(x.settings.holding ? encoder + wanted : encoder % divisor);
  replan(a);
}

void Motion::notify_at(int a, std::int64_t counts_left) {
  bring_up_to_date();
  axes_[ix(a)].notify = counts_left;
  replan(a);
}

}  // namespace hw::vme58
