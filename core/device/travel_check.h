#pragma once
// What the pump refuses because the user's travel ends before it, and how far a jog may go. Homing is let
// through, as it looks for the place that the limits count from, and so is a text of the user's own: of that
// TravelWatch tells.
#include <cstdint>
#include <optional>
#include <string>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/refusals.h"
#include "core/device/snapshot.h"

namespace hw {

/// The first place outside to which it would send an axis. On the way back, from further out, no place is.
std::optional<PastTravel> past_travel(const Catalog& catalog, const Snapshot& now, const IntentBody& body);
/// "168.000 mm lies 18.000 mm past the + limit of axis X, 150.000 mm. Nothing was sent."
std::string say_past(const Catalog& catalog, const PastTravel& past, const PlaceWords& place);

/// Fills in JogStart::up_to. Not empty: the axis stands at the end of its travel, or outside.
std::string bound_by_travel(const Catalog& catalog, const Snapshot& now, intent::JogStart& jog);

/// Both ends, if they can be ends. Not empty: why they cannot.
std::string say_no_travel(const Catalog& catalog, const intent::SetTravel& wish);

/// Tells once when an axis has passed an end of its travel, whoever has sent it there.
class TravelWatch {
 public:
  explicit TravelWatch(const Catalog& catalog) : catalog_(catalog) {}
  /// The sentence; empty: nothing new.
  std::string look(const Snapshot& now);

 private:
  const Catalog& catalog_;
  std::uint32_t outside_ = 0;  ///< bit per axis
};

}  // namespace hw
