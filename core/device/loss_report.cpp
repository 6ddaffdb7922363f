#include "core/device/loss_report.h"

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/refusals.h"

namespace hw {

void LossReport::lost(const Snapshot& last_known, bool at_work, bool on_the_way, Instant at) {
  owed_ = at_work || on_the_way;
  was_at_work_ = at_work;
  lost_at_ = at;
  restarts_ = last_known.restarts;
  for (int i = 0; i < last_known.axis_count; ++i)
    places_[ix(i)] = {last_known.axes[i].position_known, last_known.axes[i].position};
}

std::string LossReport::back(const Catalog& catalog, const Snapshot& known, bool at_work, Instant at) {
  if (!owed_) return {};
  std::string places;
  for (int i = 0; i < known.axis_count; ++i) {
    const AxisState& axis = known.axes[i];
    const Place& before = places_[ix(i)];
    if (before.known && !(axis.position_known && axis.seen_at > lost_at_)) return {};  // not read yet
    if (!axis.position_known || (before.known && before.position == axis.position)) continue;
    places +=
        fmt::format("{}{} {} at {} {}", places.empty() ? "" : ", ", spoken_name(catalog, i),
                    known.axis_moves(i) ? "moves, and is" : "stands", axis.position.value, catalog.step_word);
  }
  owed_ = false;
  if (known.restarts != restarts_) return {};  // the power cycle is reported, and ends the motions
  if (places.empty() && !at_work) places = "every axis is where it was";
  const char* what = was_at_work_ ? "the controller was busy" : "a command was on its way";
  const char* now = was_at_work_ ? at_work ? "It is still busy" : "It has finished meanwhile"
                    : at_work    ? "The controller is busy"
                                 : "The controller is at rest";
  return fmt::format("The connection was lost for {:.1f} s while {}. {}{}{}. Nothing was sent again.",
                     seconds(at - lost_at_), what, now, places.empty() ? "" : "; ", places);
}

}  // namespace hw
