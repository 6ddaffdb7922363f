#include "core/device/axis_tracking.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/index.h"
#include "core/device/catalog.h"

namespace hw {
namespace {

constexpr Duration longest_stop = std::chrono::seconds(30);

}  // namespace

void AxisTracking::begun(int index, const Motion& motion) {
  Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = draft_.axes[ix(index)];
  tracked.wanted = motion.activity;
  tracked.stopped_by = EndedBy::nothing;
  tracked.begun_at = scheduler_.now();
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
  for (int i = 0; i < draft_.axis_count; ++i) {
    if (only >= 0 && i != only) continue;
    AxisState& axis = draft_.axes[ix(i)];
    if (at_once && draft_.axis_moves(i) && !axis.trust.doubtful() && may_lose_steps && may_lose_steps(i))
      axis.trust.doubt(Doubt::killed, scheduler_.now());
    tracked_[ix(i)].stopped_by = at_once ? EndedBy::abort : EndedBy::stop;
    if (draft_.axis_moves(i)) axis.activity = Activity::stopping;
  }
}

void AxisTracking::read(int index, const Reading& reading, Instant asked_at) {
  Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = draft_.axes[ix(index)];
  const bool was_known = axis.position_known;
  const Steps way = reading.position - axis.position;
  axis.position = reading.position;
  axis.position_known = axis.limits_known = true;
  axis.seen_at = asked_at;
  axis.speed = reading.speed;
  axis.limit_minus = reading.limit_minus;
  axis.limit_plus = reading.limit_plus;
  if (asked_at < tracked.begun_at) return;  // it tells nothing of the motion begun since
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
  AxisState& axis = draft_.axes[ix(index)];
  const bool stops = tracked.stopped_by != EndedBy::nothing;
  axis.activity = stops                              ? Activity::stopping
                  : tracked.wanted == Activity::idle ? Activity::moving
                                                     : tracked.wanted;
  axis.ended_by = EndedBy::nothing;
}

void AxisTracking::show_ended(int index, bool found_home) {
  Tracked& tracked = tracked_[ix(index)];
  AxisState& axis = draft_.axes[ix(index)];
  if (draft_.axis_moves(index)) {
    const bool homes = tracked.wanted == Activity::homing;
    const bool homed = homes && found_home && tracked.stopped_by == EndedBy::nothing;
    const bool at_limit = axis.direction < 0 ? axis.limit_minus : axis.limit_plus;
    const bool missed = homes || (axis.has_target && axis.position != axis.target);
    axis.ended_by = homed                                      ? EndedBy::target
                    : at_limit && (missed || !axis.has_target) ? EndedBy::limit
                    : tracked.stopped_by != EndedBy::nothing   ? tracked.stopped_by
                    : missed                                   ? EndedBy::elsewhere
                                                               : EndedBy::target;
    if (homed) axis.trust.settle(Trust::homed, scheduler_.now());
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
  for (int i = 0; i < draft_.axis_count; ++i) {
    if (order.axis >= 0 && i != order.axis) continue;
    const Tracked& tracked = tracked_[ix(i)];
    if (tracked.asked_at >= order.sent_at && !tracked.moves) continue;
    if (scheduler_.now() - order.first_sent_at < longest_stop) return StopProgress::wait();
    return StopProgress::failed(
        Fault(FaultKind::controller, "The controller was told to stop and still moves.", "The stop was sent.",
              "Stop again: it then stops at once, without a ramp."));
  }
  return StopProgress::stands();
}

void AxisTracking::restarted() {
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[ix(i)];
    if (draft_.axis_moves(i)) axis.ended_by = EndedBy::lost;
    axis.activity = Activity::unknown;
    axis.has_target = false;
    axis.trust.doubt(Doubt::power_cut, scheduler_.now());
    tracked_[ix(i)] = Tracked();
  }
}

void AxisTracking::wire_lost() { tracked_ = {}; }

std::optional<double> stopping_way_by_ramp(const Catalog& catalog, const Snapshot& now, AxisId axis) {
  const AxisState& a = now.axes[axis.index];
  if (a.ramp <= 0 || a.activity == Activity::stopping) return {};
  const double speed = a.speed.value > 0 ? a.speed.value : catalog.jog_speed.value;
  double way = speed * speed / (2 * a.ramp);
  way = std::min(way, static_cast<double>(std::llabs((a.position - a.began_at).value)));
  if (a.has_target) way = std::min(way, static_cast<double>(std::llabs((a.target - a.position).value)));
  return way;
}

}  // namespace hw
