#include "core/devices/arcus/motions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_motion.h"

namespace hw::arcus {
namespace {

bool loop_works(int state) {
  return (state >= static_cast<int>(LoopState::moving) &&
          state <= static_cast<int>(LoopState::index_homing)) ||
         state == static_cast<int>(LoopState::limit_homing);
}

bool loop_stops(int state) {
  return state == static_cast<int>(LoopState::stopping) || state == static_cast<int>(LoopState::aborting);
}

/// Whether the loop is neither slowing down nor correcting: after a stop, this is the next motion.
bool loop_sets_out(int state) {
  return loop_works(state) && !loop_stops(state) && state != static_cast<int>(LoopState::correcting);
}

/// The motor or its encoder did not follow, so it is unknown which of the two counts is true.
bool loses_its_place(AxisError error) {
  return error == AxisError::stalled || error == AxisError::too_far || error == AxisError::not_corrected;
}

Activity activity_of(int loop_state) {
  switch (static_cast<LoopState>(loop_state)) {
    case LoopState::jogging: return Activity::jogging;
    case LoopState::homing:
    case LoopState::index_homing:
    case LoopState::limit_homing: return Activity::homing;
    case LoopState::stopping:
    case LoopState::aborting: return Activity::stopping;
    default: return Activity::moving;
  }
}

}  // namespace

// ---- commands of the console

void Motions::begun(int index, Activity activity, Instant when) {
  AxisTracking& tracking = tracked_[ix(index)];
  tracking.wanted = activity;
  tracking.ours = true;
  tracking.stopping = false;
  tracking.ended_by = EndedBy::nothing;
  tracking.begun_at = when;
  tracking.top_speed = {};
  tracking.home.begin();
  tracking.was_stopped = false;
  AxisState& axis = console_.snapshot.axes[index];
  const bool rests = axis.position_known && !console_.snapshot.axis_moves(index);
  tracking.at_rest_at = rests ? axis.seen_at : Instant{};
  tracking.at_rest = axis.position;
  begin_motion(axis, activity);
  axis.error = AxisError::none;  // a later error of this kind is new, even if no round sees a motion
  console_.snapshot.program.ended_by = EndedBy::nothing;
}

void Motions::begun_together(const std::vector<int>& axes, Activity activity) {
  unsigned together = 0;
  for (const int axis : axes) together |= 1u << axis;
  for (const int axis : axes) {
    begun(axis, activity, console_.scheduler.now());
    tracked_[ix(axis)].with = together;
  }
}

void Motions::goes_to(int index, Steps target, Pps speed) {
  AxisState& axis = console_.snapshot.axes[index];
  axis.has_target = true;
  axis.target = target;
  tracked_[ix(index)].top_speed = speed.value > 0 ? speed : axis.own_speed;
}

void Motions::searches(int index, Sign side, Pps speed) {
  AxisTracking& tracking = tracked_[ix(index)];
  AxisState& axis = console_.snapshot.axes[index];
  axis.has_target = false;
  tracking.top_speed = speed.value > 0 ? speed : axis.own_speed;
  if (tracking.at_rest_at == Instant{} || tracking.top_speed.value <= 0) return;
  tracking.home.begin(tracking.at_rest, tracking.at_rest_at, static_cast<int>(factor(side)),
                      tracking.top_speed);
}

void Motions::goes_elsewhere(int axis, Steps target) {
  console_.snapshot.axes[axis].target = target;
  console_.snapshot.axes[axis].has_target = true;
  tracked_[ix(axis)].ours = true;
  tracked_[ix(axis)].wanted = Activity::moving;
}

void Motions::another_begins(int axis) {
  AxisTracking& tracking = tracked_[ix(axis)];
  tracking.ours = false;
  tracking.with = 0;
  tracking.wanted = Activity::idle;
  console_.snapshot.axes[axis].has_target = false;
}

void Motions::stopping(int axis, bool at_once) {
  for (int i = 0; i < console_.axes(); ++i) {
    if ((axis >= 0 && i != axis) || !console_.snapshot.axis_moves(i)) continue;
    ended_by_us(i, at_once ? EndedBy::abort : EndedBy::stop);
    stop_motion(console_.snapshot.axes[i]);
    tracked_[ix(i)].stopping = true;
  }
}

void Motions::ended_by_us(int axis, EndedBy why) {
  for (int i = 0; i < console_.axes(); ++i) {
    if (!console_.snapshot.axis_moves(i) || (i != axis && (tracked_[ix(axis)].with >> i & 1u) == 0)) continue;
    tracked_[ix(i)].ended_by = ended_by_stop(tracked_[ix(i)].ended_by, why == EndedBy::abort);
    tracked_[ix(i)].was_stopped = true;
    if (why == EndedBy::abort) doubt_killed_position(i);
  }
}

// ABORT ends the pulses, not the motion of the mass: a step motor stays in step only up to the speed at which
// it also starts without a ramp. With StepNLoop the encoder counts the real motion.
void Motions::doubt_killed_position(int index) {
  AxisState& axis = console_.snapshot.axes[index];
  if (axis.in_counts || axis.trust.doubtful()) return;
  const std::int64_t safe = setup_.start_speed(index);
  const Kill kill{.axis = fmt::format("Axis {}", console_.axis_name(index)),
                  .speed = axis.speed.value,
                  .safe = static_cast<double>(safe),
                  .unit = "pulses/s",
                  .safe_word = fmt::format("its low speed, {}", safe)};
  std::string doubt = doubt_killed(axis, kill, console_.scheduler.now());
  if (!doubt.empty()) console_.report(Notice::Kind::warning, std::move(doubt));
}

void Motions::stands(int axis) {
  for (int i = 0; i < console_.axes(); ++i) {
    if (axis >= 0 && i != axis) continue;
    tracked_[ix(i)].stopping = false;
    show(i, console_.scheduler.now());
  }
}

// ---- readings

void Motions::turned(int axis, Steps way) {
  AxisTracking& tracking = tracked_[ix(axis)];
  tracking.turned_back = false;
  if (way == Steps(0)) return;
  const auto before = std::exchange(tracking.turned, static_cast<std::int8_t>(way > Steps(0) ? 1 : -1));
  tracking.turned_back = before == -tracking.turned;
}

void Motions::seen(int index) {
  const AxisState& axis = console_.snapshot.axes[index];
  AxisTracking& tracking = tracked_[ix(index)];
  if (tracking.wanted == Activity::homing && axis.seen_at > tracking.begun_at)
    tracking.home.read(axis.position, axis.speed, axis.seen_at);
}

void Motions::loop_is(int axis, std::int64_t state) {
  AxisTracking& tracking = tracked_[ix(axis)];
  const int before = std::exchange(tracking.loop_state, static_cast<int>(state));
  if (loop_stops(before) && loop_sets_out(tracking.loop_state)) tracking.ended_by = EndedBy::nothing;
  console_.snapshot.axes[axis].in_counts = state != static_cast<std::int64_t>(LoopState::off);
}

bool Motions::take_loop(int axis, std::int64_t state, Instant asked_at) {
  if (asked_at < tracked_[ix(axis)].loop_asked_at) return false;
  tracked_[ix(axis)].loop_asked_at = asked_at;
  loop_is(axis, state);
  return true;
}

void Motions::loops_are_unknown() {
  for (AxisTracking& tracking : tracked_) tracking.loop_state = -1;
}

void Motions::loop_is_unknown(int axis) {
  if (!loop_is_off(axis)) tracked_[ix(axis)].loop_state = -1;
}

// Shows the activity of the axis, from its status word, StepNLoop and the console's command. A command sent
// after the question is not judged by its reply.
void Motions::show(int index, Instant asked_at) {
  AxisTracking& tracking = tracked_[ix(index)];
  AxisState& axis = console_.snapshot.axes[index];
  if (tracking.begun_at > asked_at) return;
  if (tracking.stopping) {  // until the stop has seen the axis stand
    axis.activity = Activity::stopping;
    return;
  }
  // An axis that a stop slows down does not reverse, unless StepNLoop corrects it: a reversal is the next
  // move of a program.
  if (tracking.turned_back && (!axis.in_counts || loop_sets_out(tracking.loop_state)))
    tracking.ended_by = EndedBy::nothing;
  if (runs(index)) {
    if (tracking.ours && tracking.wanted != Activity::idle)
      axis.activity = tracking.wanted;
    else
      axis.activity = activity_of(tracking.loop_state);
    if (axis.has_target && tracking.ours)
      axis.direction = static_cast<std::int8_t>(axis.target < axis.position ? -1 : 1);
    else if (!tracking.ours || tracking.wanted != Activity::jogging)
      axis.direction = tracking.turned;
    axis.ended_by = EndedBy::nothing;
    axis.error = AxisError::none;
    return;
  }
  if (console_.snapshot.axis_moves(index) || axis.activity == Activity::unknown) show_ended(index);
  const AxisError before = std::exchange(axis.error, error_of(index));
  if (axis.error != before && loses_its_place(axis.error) && !axis.trust.doubtful())
    axis.trust.doubt(Doubt::slipped, console_.scheduler.now());
  end_motion(axis, axis.ended_by);
  if (axis.error != AxisError::none) axis.activity = Activity::error;
}

void Motions::show_ended(int index) {
  AxisTracking& tracking = tracked_[ix(index)];
  AxisState& axis = console_.snapshot.axes[index];
  const bool was_moving = console_.snapshot.axis_moves(index);
  if (was_moving) axis.ended_by = how_it_ended(index);
  if (was_moving && tracking.wanted == Activity::homing && axis.ended_by == EndedBy::target)
    axis.trust.settle(Trust::homed, console_.scheduler.now());
  another_begins(index);
  tracking.ended_by = EndedBy::nothing;
}

void Motions::restarted(unsigned moved) {
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    if ((moved >> i & 1u) != 0) axis.ended_by = EndedBy::lost;
    tracked_[ix(i)] = AxisTracking();
    axis.has_target = false;
    axis.trust.doubt(Doubt::power_cut, console_.scheduler.now());
  }
}

void Motions::wire_lost() {
  for (AxisTracking& tracking : tracked_) tracking.stopping = false;
}

// ---- conclusions

bool Motions::runs(int axis) const {
  const AxisTracking& tracking = tracked_[ix(axis)];
  return arcus::reports_motion(tracking.status) || loop_works(tracking.loop_state);
}

bool Motions::reports_motion(int axis) const { return arcus::reports_motion(tracked_[ix(axis)].status); }

bool Motions::loop_is_off(int axis) const {
  return tracked_[ix(axis)].loop_state == static_cast<int>(LoopState::off);
}

bool Motions::loop_error(int axis) const {
  const int state = tracked_[ix(axis)].loop_state;
  return state >= static_cast<int>(LoopState::range_error) &&
         state <= static_cast<int>(LoopState::limit_error);
}

AxisError Motions::error_of(int axis) const {
  const StatusBits& bits = console_.model().status;
  const std::int64_t word = tracked_[ix(axis)].status;
  switch (static_cast<LoopState>(tracked_[ix(axis)].loop_state)) {
    case LoopState::stall_error: return AxisError::stalled;
    case LoopState::range_error: return AxisError::too_far;
    case LoopState::attempt_error: return AxisError::not_corrected;
    default: break;
  }
  if (has_bit(word, bits.minus_error)) return AxisError::limit_minus;
  if (has_bit(word, bits.plus_error)) return AxisError::limit_plus;
  if (has_bit(word, bits.alarm_error)) return AxisError::alarm;
  return loop_error(axis) ? AxisError::limit : AxisError::none;
}

EndedBy Motions::how_it_ended(int axis) const {
  const StatusBits& bits = console_.model().status;
  const std::int64_t word = tracked_[ix(axis)].status;
  if (has_bit(word, bits.plus_error) || has_bit(word, bits.minus_error)) return EndedBy::limit;
  if (has_bit(word, bits.alarm_error) || loop_error(axis)) return EndedBy::error;
  if (tracked_[ix(axis)].ended_by != EndedBy::nothing) return tracked_[ix(axis)].ended_by;
  if (was_cut_short(axis)) return EndedBy::elsewhere;
  if (!misses_its_target(axis)) return EndedBy::target;
  const unsigned with = tracked_[ix(axis)].with;
  for (int i = 0; i < console_.axes(); ++i)  // on a straight line all end with the blocked one
    if (i != axis && (with >> i & 1u) != 0 && error_of(i) != AxisError::none) return EndedBy::nothing;
  return EndedBy::elsewhere;
}

/// A motion of the console without a target that has ended for no known reason.
bool Motions::was_cut_short(int index) const {
  const AxisTracking& tracking = tracked_[ix(index)];
  const AxisState& axis = console_.snapshot.axes[index];
  if (!tracking.ours || tracking.was_stopped || axis.has_target) return false;
  if (tracking.wanted == Activity::homing) return !tracking.home.may_have_found(axis.position);
  return tracking.wanted == Activity::jogging;
}

// With StepNLoop the axis may miss its target by up to SLT.
bool Motions::misses_its_target(int index) const {
  const AxisState& axis = console_.snapshot.axes[index];
  if (!axis.has_target) return false;
  return std::abs((axis.position - axis.target).value) > (axis.in_counts ? loop_tolerance(index) : 0);
}

std::int64_t Motions::loop_tolerance(int axis) const {
  std::int64_t room = setup_.setting(Setting::loop_tolerance, axis).value_or(0);
  for (const SettingFact& fact : console_.model().settings)
    if (fact.id == Setting::loop_tolerance && room == 0) room = fact.factory;  // not read yet
  return room;
}

// How fast a counter may come to zero by its own motion. An axis moving elsewhere, or away from zero, does
// not come to rest there.
Pps Motions::fastest_way_to_zero(int index) const {
  constexpr Pps at_once{std::numeric_limits<double>::infinity()};
  const AxisState& axis = console_.snapshot.axes[index];
  const AxisTracking& tracking = tracked_[ix(index)];
  if (!console_.snapshot.axis_moves(index)) return Pps{};
  if (!tracking.ours || tracking.wanted == Activity::homing) return at_once;
  const bool away = axis.position.value * axis.direction > 0;
  if (tracking.wanted == Activity::jogging) return away ? Pps{} : std::max(axis.speed, tracking.top_speed);
  if (tracking.stopping) return away ? Pps{} : axis.speed;
  if (!axis.has_target) return at_once;
  if (axis.target != Steps(0)) return Pps{};
  return tracking.top_speed.value > 0 ? std::max(axis.speed, tracking.top_speed) : at_once;
}

RestartWatch::AxisNow Motions::now(int axis) const {
  const AxisState& state = console_.snapshot.axes[axis];
  const Steps room = state.in_counts ? Steps(loop_tolerance(axis)) : Steps(0);
  RestartWatch::AxisNow now;
  now.runs = runs(axis);
  now.moving = console_.snapshot.axis_moves(axis);
  now.to_encoder =
      state.in_counts && (tracked_[ix(axis)].stopping || loop_stops(tracked_[ix(axis)].loop_state));
  now.towards_zero = fastest_way_to_zero(axis);
  now.room = room;
  now.leaves_zero = leaves_zero(axis);
  return now;
}

bool Motions::leaves_zero(int index) const {
  const AxisState& axis = console_.snapshot.axes[index];
  const AxisTracking& tracking = tracked_[ix(index)];
  if (!runs(index) || !tracking.ours || tracking.stopping) return false;
  if (tracking.wanted == Activity::jogging) return axis.position.value * axis.direction > 0;
  return axis.has_target && std::abs(axis.target.value) > loop_tolerance(index);
}

}  // namespace hw::arcus
