#pragma once
// The user's named places: positions of several axes.
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"

namespace hw {

struct SavedPlace {
  std::string name;
  std::vector<AxisTarget> at;  ///< by AxisId; an axis not listed stays where it is
  bool operator==(const SavedPlace&) const = default;
};

using SavedPlaces = std::vector<SavedPlace>;  ///< in the order in which they were first saved

/// Null: no place of that name.
const SavedPlace* find_place(const SavedPlaces& places, std::string_view name);
/// Adds `place`, or replaces the place of that name. A place without axes removes it.
void put_place(SavedPlaces& places, SavedPlace place);
/// Positions or targets of all axes. A fault names an axis whose position is untrusted or unknown.
Result<std::vector<AxisTarget>> standing_place(const Catalog& catalog, const Snapshot& now);
/// "a, b, c"; empty: no places.
std::string names_of(const SavedPlaces& places);

}  // namespace hw
