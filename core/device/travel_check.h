#pragma once
// Refuses intents that go past the user's limits, and limits jogs. Homing is allowed, as it finds the zero
// that the limits count from. The user's own text is allowed too; TravelWatch reports on it.
#include <cstdint>
#include <optional>
#include <string>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/refusals.h"
#include "core/device/snapshot.h"

namespace hw {

/// The limits of at least one axis apply.
[[nodiscard]] bool some_travel_holds(const Snapshot& now);
/// The first place past a limit to which the intent would send an axis. None for a move back from further
/// out.
std::optional<PastTravel> past_travel(const Catalog& catalog, const Snapshot& now, const IntentBody& body);
/// "168.000 mm lies 18.000 mm past the + limit of axis X, 150.000 mm. Nothing was sent."
std::string describe_past(const Catalog& catalog, const PastTravel& past, const PlaceWords& place);
/// The place nearest to the refused one to which its axis may be sent.
Steps nearest_allowed(const Snapshot& now, const PastTravel& past);

/// Fills in JogStart::up_to. Returns the limit if the axis is at it or past it: the jog is refused.
std::optional<PastTravel> bound_by_travel(const Snapshot& now, intent::JogStart& jog);

/// Checks limits to be set. Not empty: why they are not possible, as a sentence.
std::string describe_no_travel(const Catalog& catalog, const intent::SetTravel& request,
                               const PlaceWords& place);

/// "Axis X has passed its + limit, 150.000 mm: nothing ends this motion there.", or, for a text, the limit
/// that it leads past.
std::string describe_warned(const Catalog& catalog, const PastTravel& past, const PlaceWords& place);

/// Reports once when an axis has passed a limit, whoever sent it there.
class TravelWatch {
 public:
  /// None: no axis has since the last call, or it was reported already. Of several, one in each call.
  std::optional<PastTravel> look(const Snapshot& now);

 private:
  std::uint32_t outside_ = 0;  ///< bit per axis
};

}  // namespace hw
