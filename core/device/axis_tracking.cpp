#include "core/device/axis_tracking.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_motion.h"
#include "core/device/catalog.h"
#include "core/device/nothing_known.h"

namespace hw {

void AxisTracking::begun(int index, const Motion& motion) {
  Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = context_.snapshot.axes[ix(index)];
  tracked.wanted = motion.activity;
  tracked.stopped_by = EndedBy::nothing;
  tracked.begun_at = context_.scheduler.now();
  tracked.moves = true;
  begin_motion(axis, motion.activity, motion.target);
  const Sign sign = !motion.target ? motion.sign : *motion.target < axis.position ? Sign::minus : Sign::plus;
  axis.direction = static_cast<std::int8_t>(factor(sign));
  axis.ramp = motion.ramp;
  axis.began_at = axis.position;
}

void AxisTracking::stopping(int only, bool at_once) {
  for (int i = 0; i < context_.snapshot.axis_count; ++i) {
    if (only >= 0 && i != only) continue;
    AxisState& axis = context_.snapshot.axes[ix(i)];
    if (at_once && axis.moves() && !axis.trust.doubtful()) may_lose_steps(i);
    tracked_[ix(i)].stopped_by =
        ended_by_stop(axis.moves() ? tracked_[ix(i)].stopped_by : EndedBy::nothing, at_once);
    stop_motion(axis);
  }
}

/// A motor above its start speed overshoots when it is stopped at once.
void AxisTracking::may_lose_steps(int index) {
  AxisState& axis = context_.snapshot.axes[ix(index)];
  const std::string unit = context_.catalog.step_word + "/s";
  const Kill kill{.axis = "Axis " + context_.catalog.axes[ix(index)].name,
                  .speed = axis.speed.value,
                  .safe = start_speed_.value,
                  .unit = unit,
                  .safe_word = fmt::format("{:.0f}", start_speed_.value)};
  std::string doubt = doubt_killed(axis, kill, context_.scheduler.now());
  if (!doubt.empty()) warn(std::move(doubt));
}

void AxisTracking::warn(std::string sentence) {
  context_.notify(Notice(Notice::Kind::warning, context_.scheduler.now(), std::move(sentence)));
}

void AxisTracking::read(int index, const Reading& reading, Instant asked_at) {
  Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = context_.snapshot.axes[ix(index)];
  const bool was_known = axis.position_known;
  const Steps way = reading.position - axis.position;
  axis.position = reading.position;
  axis.position_known = axis.limits_known = true;
  axis.seen_at = asked_at;
  axis.speed = reading.speed;
  axis.limit_minus = reading.limit_minus;
  axis.limit_plus = reading.limit_plus;
  if (asked_at < tracked.begun_at) return;  // the reading is older than the motion
  tracked.asked_at = asked_at;
  tracked.moves = reading.moves;
  if (!reading.moves) return show_ended(index, reading.homed);
  if (axis.direction == 0 && was_known)
    axis.direction = static_cast<std::int8_t>((way > Steps(0)) - (way < Steps(0)));
  show_moving(index);
}

/// A motion that this console has not begun is shown as a move.
void AxisTracking::show_moving(int index) {
  const Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = context_.snapshot.axes[ix(index)];
  const bool stops = tracked.stopped_by != EndedBy::nothing;
  axis.activity = stops                              ? Activity::stopping
                  : tracked.wanted == Activity::idle ? Activity::moving
                                                     : tracked.wanted;
  axis.ended_by = EndedBy::nothing;
}

void AxisTracking::show_ended(int index, bool found_home) {
  Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = context_.snapshot.axes[ix(index)];
  EndedBy ended_by = axis.ended_by;
  if (axis.moves()) {
    const bool homes = tracked.wanted == Activity::homing;
    const bool homed = homes && found_home && tracked.stopped_by == EndedBy::nothing;
    const bool at_limit = axis.direction < 0 ? axis.limit_minus : axis.limit_plus;
    const bool jogs = tracked.wanted == Activity::jogging && !axis.has_target;  // only a stop ends it
    const bool missed = homes || jogs || (axis.has_target && axis.position != axis.target);
    ended_by = homed                                      ? EndedBy::target
               : at_limit && (missed || !axis.has_target) ? EndedBy::limit
               : tracked.stopped_by != EndedBy::nothing   ? tracked.stopped_by
               : missed                                   ? EndedBy::elsewhere
                                                          : EndedBy::target;
    if (homed) axis.trust.settle(Trust::homed, context_.scheduler.now());
  }
  end_motion(axis, ended_by);
  tracked.wanted = Activity::idle;
  tracked.stopped_by = EndedBy::nothing;
}

StopProgress AxisTracking::progress(const StopOrder& order) const {
  using What = StopOrder::What;
  if (order.what != What::everything && order.what != What::jog) return StopProgress::stands();
  for (int i = 0; i < context_.snapshot.axis_count; ++i) {
    if (order.axis >= 0 && i != order.axis) continue;
    const Tracked& tracked = tracked_[ix(i)];
    if (tracked.asked_at >= order.sent_at && !tracked.moves) continue;
    return progress_of_stop(true, context_.scheduler.now() - order.first_sent_at);
  }
  return StopProgress::stands();
}

void AxisTracking::restarted() {
  ++context_.snapshot.restarts;
  set_up_is_unknown(context_.snapshot);
  for (int i = 0; i < context_.snapshot.axis_count; ++i) {
    AxisState& axis = context_.snapshot.axes[ix(i)];
    lose_motion(axis);
    axis.has_target = false;
    axis.trust.doubt(Doubt::power_cut, context_.scheduler.now());
    tracked_[ix(i)] = Tracked();
  }
  warn("Home the axes before the next absolute move: the controller was switched off and on.");
}

void AxisTracking::wire_lost() {
  tracked_ = {};
  nothing_is_known(context_.snapshot);
}

}  // namespace hw
