#include "core/device/sequence_travel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/index.h"
#include "core/base/rounded_steps.h"
#include "core/sequence/places_before.h"

namespace hw {

namespace seq = sequence;  // files of this folder are compiled together
namespace {

seq::Places standing_at(const seq::Sequence& sequence, const Catalog& catalog, const Snapshot& now) {
  seq::Places begin;
  for (std::size_t a = 0; a < sequence.axes.size(); ++a) {
    const int axis = catalog.find_axis(sequence.axes[a].name);
    if (axis < 0 || !now.axes[ix(axis)].position_known || now.axes[ix(axis)].trust.doubtful()) continue;
    begin[a] = static_cast<double>(now.axes[ix(axis)].commanded().value) / sequence.axes[a].per_unit;
  }
  return begin;
}

/// By index in the sequence.
std::array<bool, max_axes> doubtful_in(const seq::Sequence& sequence, const Catalog& catalog,
                                       const Snapshot& now) {
  std::array<bool, max_axes> doubtful{};
  for (std::size_t a = 0; a < sequence.axes.size(); ++a)
    if (const int axis = catalog.find_axis(sequence.axes[a].name); axis >= 0 && axis < max_axes)
      doubtful[a] = now.axes[ix(axis)].trust.doubtful();
  return doubtful;
}

}  // namespace

std::vector<AxisTarget> places_of_run(const seq::Sequence& sequence, const Catalog& catalog,
                                      const Snapshot& now) {
  const seq::Places begin = standing_at(sequence, catalog, now);
  const seq::Reach reach =
      seq::reaches_between(sequence, {0, sequence.steps.size()}, begin, doubtful_in(sequence, catalog, now))
          .front();
  std::vector<AxisTarget> places;
  for (std::size_t a = 0; a < sequence.axes.size(); ++a) {
    const int at = catalog.find_axis(sequence.axes[a].name);
    if (at < 0 || at >= max_axes) continue;
    const bool has_end = !reach.endless_minus[a] && !reach.endless_plus[a];
    if (has_end && reach.least[a] == begin[a] && reach.greatest[a] == begin[a]) continue;
    const auto put = [&](const std::optional<double>& units, bool endless, Steps end) {
      const AxisId axis{static_cast<std::uint8_t>(at)};
      if (endless)
        places.push_back({axis, end});
      else if (units)
        places.push_back({axis, rounded_steps(*units * sequence.axes[a].per_unit)});
    };
    put(reach.least[a], reach.endless_minus[a], Steps(0) - without_end);
    put(reach.greatest[a], reach.endless_plus[a], without_end);
  }
  return places;
}

}  // namespace hw
