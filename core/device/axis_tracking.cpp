#include "core/device/axis_tracking.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/catalog.h"
#include "core/device/nothing_known.h"

namespace hw {
namespace {

constexpr Duration longest_stop = std::chrono::seconds(30);

}  // namespace

void AxisTracking::begun(int index, const Motion& motion) {
  Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = context_.snapshot.axes[ix(index)];
  tracked.wanted = motion.activity;
  tracked.stopped_by = EndedBy::nothing;
  tracked.begun_at = context_.scheduler.now();
  tracked.moves = true;
  axis.activity = motion.activity;
  axis.ended_by = EndedBy::nothing;
  axis.has_target = motion.target.has_value();
  axis.target = motion.target.value_or(Steps(0));
  const Sign sign = !motion.target ? motion.sign : *motion.target < axis.position ? Sign::minus : Sign::plus;
  axis.direction = static_cast<std::int8_t>(factor(sign));
  axis.ramp = motion.ramp;
  axis.began_at = axis.position;
}

void AxisTracking::stopping(int only, bool at_once) {
  for (int i = 0; i < context_.snapshot.axis_count; ++i) {
    if (only >= 0 && i != only) continue;
    AxisState& axis = context_.snapshot.axes[ix(i)];
    if (at_once && context_.snapshot.axis_moves(i) && !axis.trust.doubtful()) may_lose_steps(i);
    const bool killed = context_.snapshot.axis_moves(i) && tracked_[ix(i)].stopped_by == EndedBy::abort;
    tracked_[ix(i)].stopped_by = at_once || killed ? EndedBy::abort : EndedBy::stop;
    if (context_.snapshot.axis_moves(i)) axis.activity = Activity::stopping;
  }
}

/// A motor that runs faster than it can start overshoots when it is stopped at once.
void AxisTracking::may_lose_steps(int index) {
  AxisState& axis = context_.snapshot.axes[ix(index)];
  if (axis.speed <= start_speed_) return;
  axis.trust.doubt(Doubt::killed, context_.scheduler.now());
  warn(
      fmt::format("Axis {} may have lost steps, as it was stopped at speed without a ramp. Home it, or set "
                  "its position.",
                  context_.catalog.axes[ix(index)].name));
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
  if (asked_at < tracked.begun_at) return;  // it shows nothing of the motion begun since
  tracked.asked_at = asked_at;
  tracked.moves = reading.moves;
  if (!reading.moves) return show_ended(index, reading.homed);
  if (axis.direction == 0 && was_known)
    axis.direction = static_cast<std::int8_t>((way > Steps(0)) - (way < Steps(0)));
  show_moving(index);
}

/// A motion that this console has not begun, or of which it does not know, is shown as a move.
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
  if (context_.snapshot.axis_moves(index)) {
    const bool homes = tracked.wanted == Activity::homing;
    const bool homed = homes && found_home && tracked.stopped_by == EndedBy::nothing;
    const bool at_limit = axis.direction < 0 ? axis.limit_minus : axis.limit_plus;
    const bool jogs = tracked.wanted == Activity::jogging && !axis.has_target;  // only a stop ends it
    const bool missed = homes || jogs || (axis.has_target && axis.position != axis.target);
    axis.ended_by = homed                                      ? EndedBy::target
                    : at_limit && (missed || !axis.has_target) ? EndedBy::limit
                    : tracked.stopped_by != EndedBy::nothing   ? tracked.stopped_by
                    : missed                                   ? EndedBy::elsewhere
                                                               : EndedBy::target;
    if (homed) axis.trust.settle(Trust::homed, context_.scheduler.now());
  }
  axis.activity = Activity::idle;
  axis.direction = 0;
  axis.ramp = 0;
  axis.has_target = false;
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
    if (context_.scheduler.now() - order.first_sent_at < longest_stop) return StopProgress::wait();
    return StopProgress::failed(Fault(FaultKind::controller, "Stop was sent, but the controller still moves.",
                                      "", "Stop again: it then stops at once, without a ramp."));
  }
  return StopProgress::stands();
}

void AxisTracking::restarted() {
  ++context_.snapshot.restarts;
  set_up_is_unknown(context_.snapshot);
  for (int i = 0; i < context_.snapshot.axis_count; ++i) {
    AxisState& axis = context_.snapshot.axes[ix(i)];
    if (context_.snapshot.axis_moves(i)) axis.ended_by = EndedBy::lost;
    axis.activity = Activity::unknown;
    axis.has_target = false;
    axis.trust.doubt(Doubt::power_cut, context_.scheduler.now());
    tracked_[ix(i)] = Tracked();
  }
  warn("The controller was switched off and on. Home the axes before the next move to a place.");
}

void AxisTracking::wire_lost() {
  tracked_ = {};
  nothing_is_known(context_.snapshot);
}

}  // namespace hw
