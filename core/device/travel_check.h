#pragma once
// Refuses intents that go past the user's limits, and limits jogs. Homing is allowed, as it finds the zero of
// the limits, and so is the user's own text, on which TravelWatch reports.
#include <cstdint>
#include <optional>
#include <string>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/refusals.h"
#include "core/device/snapshot.h"

namespace hw {

/// The first place past a limit to which it would send an axis. On the way back, from further out, none is.
std::optional<PastTravel> past_travel(const Catalog& catalog, const Snapshot& now, const IntentBody& body);
/// "168.000 mm lies 18.000 mm past the + limit of axis X, 150.000 mm. Nothing was sent."
std::string describe_past(const Catalog& catalog, const PastTravel& past, const PlaceWords& place);
/// The place nearest to the refused one to which its axis may be sent.
Steps nearest_allowed(const Snapshot& now, const PastTravel& past);

/// Fills in JogStart::up_to. Returns the limit of an axis at it or past it, which refuses the jog.
std::optional<PastTravel> bound_by_travel(const Snapshot& now, intent::JogStart& jog);

/// Checks limits to be set. Not empty: why they are not possible.
std::string describe_no_travel(const Catalog& catalog, const intent::SetTravel& request,
                               const PlaceWords& place);

/// "Axis X has passed its + limit, 150.000 mm: nothing ends this motion there.", or of a text what it leads
/// past.
std::string describe_warned(const Catalog& catalog, const PastTravel& past, const PlaceWords& place);

/// Reports once when an axis has passed a limit, whoever sent it there.
class TravelWatch {
 public:
  /// Nothing: none has since the last call, or that was reported; of several, one in each call.
  std::optional<PastTravel> look(const Snapshot& now);

 private:
  std::uint32_t outside_ = 0;  ///< bit per axis
};

}  // namespace hw
