#include "panels/program/travel_words.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "panels/program/rehearsal_words.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

/// The distance beyond that end; nullopt: not beyond, or the end has no effect.
static std::optional<Steps> furthest_past(const AxisState& axis, const RehearsedAxis& rehearsed, Sign side) {
  if (!axis.travel_holds() || rehearsed.in_counts != axis.in_counts) return {};
  const Steps furthest(side == Sign::minus ? rehearsed.minimum : rehearsed.maximum);
  return axis.travel.past(side, furthest) > Steps(0) ? std::optional(furthest) : std::nullopt;
}

bool passes_travel(const Frame& f, const Rehearsal& r) {
  for (std::size_t i = 0; i < std::min(r.axes.size(), f.catalog.axes.size()); ++i)
    for (const Sign side : {Sign::minus, Sign::plus})
      if (furthest_past(f.now.axes[i], r.axes[i], side)) return true;
  return false;
}

/// The time in seconds of the first position beyond that end, as far as the track was kept; negative:
/// unknown.
static double first_time_past(const Rehearsal& r, std::size_t axis, Sign side, const Travel& travel) {
  const auto found = std::find_if(r.track.begin(), r.track.end(), [&](const RehearsedPlace& place) {
    return travel.past(side, Steps(place.position[axis])) > Steps(0);
  });
  return found == r.track.end() ? -1 : found->t;
}

std::vector<std::string> past_travel_words(const Frame& f, const Rehearsal& r) {
  std::vector<std::string> all;
  const std::size_t axes = std::min(r.axes.size(), f.catalog.axes.size());
  for (std::size_t i = 0; i < axes; ++i) {
    const AxisState& axis = f.now.axes[i];
    const DisplayUnit& unit = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(i)});
    for (const Sign side : {Sign::minus, Sign::plus}) {
      const auto furthest = furthest_past(axis, r.axes[i], side);
      if (!furthest) continue;
      const double t = first_time_past(r, i, side, axis.travel);
      const std::string when = t < 0 ? std::string() : fmt::format(" after {}", exact_time(t));
      all.push_back(fmt::format("Past the {} limit of {}, {},{} and up to {}.", sign_text(side),
                                f.catalog.axes[i].name, format_with_unit(axis.travel.end(side), unit).view(),
                                when, format_with_unit(*furthest, unit).view()));
    }
  }
  return all;
}

}  // namespace hw::panels
