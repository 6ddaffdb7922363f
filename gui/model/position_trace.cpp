#include "gui/model/position_trace.h"

#include <algorithm>
#include <utility>

namespace hw::gui {
namespace {

constexpr std::size_t most_places = 100'000;

/// False: the position of some axis is not known, or its count may be wrong.
bool find_place(const Snapshot& now, PositionTrace::Place& place) {
  if (!now.link.connected() || now.axis_count == 0) return false;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[static_cast<std::size_t>(i)];
    if (!axis.position_known || axis.trust.doubtful()) return false;
    place.position[static_cast<std::size_t>(i)] = axis.position;
    place.counted_since[static_cast<std::size_t>(i)] = axis.trust.since;
  }
  place.at = place.until = now.at;
  return true;
}

}  // namespace

/// A switch may be operated over some distance: the travel ends at the place where it was first operated.
void PositionTrace::meet(const AxisState& axis, Followed& f) {
  if (std::exchange(f.counted_since, axis.trust.since) != axis.trust.since ||
      std::exchange(f.in_counts, axis.in_counts) != axis.in_counts)
    f.met = {};
  const bool was_homing = std::exchange(f.homing, axis.activity == Activity::homing);
  if (!axis.position_known || axis.trust.doubtful()) return;
  if (axis.limits_known && axis.limit_minus)
    f.met.minus = std::max(f.met.minus.value_or(axis.position), axis.position);
  if (axis.limits_known && axis.limit_plus)
    f.met.plus = std::min(f.met.plus.value_or(axis.position), axis.position);
  const bool came_home = was_homing && axis.activity == Activity::idle && axis.ended_by == EndedBy::target;
  if (axis.home || came_home) f.met.home = axis.position;
}

void PositionTrace::follow(const Snapshot& now) {
  for (int i = 0; now.link.connected() && i < now.axis_count; ++i)
    meet(now.axes[static_cast<std::size_t>(i)], followed_[static_cast<std::size_t>(i)]);
  Place place;
  if (!find_place(now, place)) {
    broken_ = true;
    return;
  }
  const bool first = std::exchange(broken_, false) || places_.empty();
  // A count set anew gives the places other names than before.
  place.goes_on = !first && places_.back().counted_since == place.counted_since;
  if (place.goes_on && places_.back().position == place.position) {
    places_.back().until = place.at;
    return;
  }
  if (count_ == 0) first_at_ = place.at;
  places_.push_back(place);
  if (places_.size() > most_places) places_.pop_front();
  ++count_;
}

void PositionTrace::clear() {
  places_.clear();
  broken_ = true;
  count_ = 0;
  ++begun_;
}

}  // namespace hw::gui
