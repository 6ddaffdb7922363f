#include "gui/position_trace.h"

#include <utility>

namespace hw::gui {
namespace {

constexpr std::size_t most_places = 100'000;

/// False: some axis is where nobody knows, or its count may not be true.
bool find_place(const Snapshot& now, PositionTrace::Place& place) {
  if (!now.link.connected() || now.axis_count == 0) return false;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[static_cast<std::size_t>(i)];
    if (!axis.position_known || axis.trust.doubtful()) return false;
    place.position[static_cast<std::size_t>(i)] = axis.position;
    place.counted_since[static_cast<std::size_t>(i)] = axis.trust.since;
  }
  place.at = now.at;
  return true;
}

}  // namespace

void PositionTrace::follow(const Snapshot& now) {
  Place place;
  if (!find_place(now, place)) {
    broken_ = true;
    return;
  }
  const bool first = std::exchange(broken_, false) || places_.empty();
  // A count that was set anew names other places than before.
  place.goes_on = !first && places_.back().counted_since == place.counted_since;
  if (place.goes_on && places_.back().position == place.position) return;
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
