#pragma once
// Places of the user's own, by name: where several axes stand together.
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
  std::vector<AxisTarget> at;  ///< by AxisId; an axis that is not named stays where it is
  bool operator==(const SavedPlace&) const = default;
};

using SavedPlaces = std::vector<SavedPlace>;  ///< in the order in which they were first saved

/// Null: there is none of that name.
const SavedPlace* find_place(const SavedPlaces& places, std::string_view name);
/// In the place of one of that name; without axes that is forgotten.
void put_place(SavedPlaces& places, SavedPlace place);
/// Where all axes stand or are sent. Not to be trusted, or not known: a fault that says which.
Result<std::vector<AxisTarget>> standing_place(const Catalog& catalog, const Snapshot& now);
/// "a, b, c"; empty: there is none.
std::string names_of(const SavedPlaces& places);

}  // namespace hw
