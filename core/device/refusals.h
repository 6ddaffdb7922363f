#pragma once
// What the pump refuses on any controller, before its driver is asked: to go to a place by a count that is
// not to be trusted, and to run a program that is not what was sent. And what the console itself does not ask
// for: to move an axis whose motor has no current. (A controller counts such a move all the same, and
// programs elsewhere rely on that.)
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"

namespace hw {

/// "motor 1", "axis X", "axis X of device 03", on the console's bus "device 03": within a sentence.
std::string spoken_name(const Catalog& catalog, int axis);

// ---- the count

/// Where it sends which axes by their counts; empty: it takes no count for true. A distance does not, nor
/// does the user's own text.
std::vector<AxisTarget> places_of(const Catalog& catalog, const IntentBody& body);

/// Bit per axis that it would send to a place although its position is not to be trusted.
std::uint32_t doubtful_axes(const Catalog& catalog, const Snapshot& now, const IntentBody& body);

/// How a sentence writes a place.
using PlaceWords = std::function<std::string(AxisId, Steps)>;
/// The same, and a time.
struct DoubtWords {
  PlaceWords position;
  std::function<std::string(Instant)> time_of_day;      ///< empty: there is no clock
  [[nodiscard]] std::string when(Instant since) const;  ///< " (12:31:07)"
};
/// In the controller's own steps, without a clock.
DoubtWords words_in_steps(const Catalog& catalog, const Snapshot& now);
/// Why these refuse it, and the ways out.
std::string say_doubtful(const Catalog& catalog, const Snapshot& now, const IntentBody& body,
                         std::uint32_t doubtful, const DoubtWords& words);
std::string_view words_of(Doubt cause, bool several = false);  ///< "its power was cut", "their ..."
std::string_view brief_words_of(Doubt cause);                  ///< "power was cut"

/// It is to be done this once, whatever is doubtful.
void go_despite_doubt(IntentBody& body);
/// That the axis stands at `place`. Where its count says so already this is only to be trusted: not every
/// controller can be told any number.
IntentBody stands_at(const Snapshot& now, AxisId axis, Steps place);

// ---- what is stored

/// The slot of the program that it would start although what is stored there is not what was sent last; -1:
/// it does not. The user's own text is his own word.
int torn_program(const Catalog& catalog, const Snapshot& now, const IntentBody& body);
/// Why it is refused, and the ways out.
std::string say_torn(const Catalog& catalog, int slot);
/// For whoever closes it; empty: all is as it was sent.
std::string say_torn_is_left(const Catalog& catalog, const Snapshot& now);
/// Where what is stored as program `n` is marked in Snapshot::slots_torn.
std::uint8_t torn_bit(const Catalog& catalog, int n);

// ---- the current

/// Its motor is switched off: the console offers the switch before anything else.
[[nodiscard]] bool powerless(const Catalog& catalog, const Snapshot& now, AxisId axis);

}  // namespace hw
