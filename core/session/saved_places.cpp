#include "core/session/saved_places.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/refusals.h"

namespace hw {

const SavedPlace* find_place(const SavedPlaces& places, std::string_view name) {
  const auto found =
      std::find_if(places.begin(), places.end(), [&](const SavedPlace& p) { return p.name == name; });
  return found == places.end() ? nullptr : &*found;
}

void put_place(SavedPlaces& places, SavedPlace place) {
  const auto same =
      std::find_if(places.begin(), places.end(), [&](const SavedPlace& p) { return p.name == place.name; });
  if (place.at.empty()) {
    if (same != places.end()) places.erase(same);
  } else if (same != places.end()) {
    *same = std::move(place);
  } else {
    places.push_back(std::move(place));
  }
}

Result<std::vector<AxisTarget>> standing_place(const Catalog& catalog, const Snapshot& now) {
  std::vector<AxisTarget> at;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[i];
    if (axis.position_known && !axis.trust.doubtful()) {
      at.push_back({AxisId{static_cast<std::uint8_t>(i)}, axis.commanded()});
      continue;
    }
    return fail(FaultKind::refused,
                fmt::format("The position of {} is not {}.", spoken_name(catalog, i),
                            axis.position_known ? "to be trusted" : "known"),
                "Nothing was saved.", "Home it, or set its position.");
  }
  return at;
}

std::string names_of(const SavedPlaces& places) {
  std::string all;
  for (const SavedPlace& place : places) all += (all.empty() ? "" : ", ") + place.name;
  return all;
}

}  // namespace hw
