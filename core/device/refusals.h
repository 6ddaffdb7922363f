#pragma once
// Refusals of the pump on any controller, before its driver is asked: absolute moves of an axis whose count
// is doubtful, and programs that differ from the text sent last. Also a refusal of the console: moving an
// axis whose motor has no current. (A controller counts such a move, and other programs rely on that.)
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

/// The targets that rely on counts; empty: none. A distance does not, nor does the user's own text.
std::vector<AxisTarget> places_of(const Catalog& catalog, const IntentBody& body);

/// A bit per axis that the intent would send to a place although its position is doubtful.
std::uint32_t doubtful_axes(const Catalog& catalog, const Snapshot& now, const IntentBody& body);

/// Formats a place for a sentence.
using PlaceWords = std::function<std::string(AxisId, Steps)>;
/// Formats a place and a time.
struct DoubtWords {
  PlaceWords position;
  std::function<std::string(Instant)> time_of_day;      ///< empty: there is no clock
  [[nodiscard]] std::string when(Instant since) const;  ///< " (12:31:07)"
};
/// In the controller's own steps, without a clock.
DoubtWords words_in_steps(const Catalog& catalog, const Snapshot& now);
/// The refusal for these axes, with the ways out.
std::string describe_doubtful(const Catalog& catalog, const Snapshot& now, const IntentBody& body,
                              std::uint32_t doubtful, const DoubtWords& words);
std::string_view words_of(Doubt cause, bool several = false);  ///< "its power was cut", "their ..."
std::string_view brief_words_of(Doubt cause);                  ///< "power was cut"

/// Marks the intent to be performed this once despite any doubt.
void go_despite_doubt(IntentBody& body);
/// The intent for "the axis stands at `place`". If the count is right already it is only trusted, as not
/// every controller can be set to any number.
IntentBody stands_at(const Snapshot& now, AxisId axis, Steps place);

// ---- stored programs

/// The slot that the intent would start although its program is not what was sent last; -1: none. The user's
/// own text is not checked.
int torn_program(const Catalog& catalog, const Snapshot& now, const IntentBody& body);
/// The refusal, with the ways out.
std::string describe_torn(const Catalog& catalog, int slot);
/// The warning when the controller is closed; empty: all programs are as sent.
std::string describe_torn_is_left(const Catalog& catalog, const Snapshot& now);
/// The bit of program `n` in Snapshot::slots_torn.
std::uint8_t torn_bit(const Catalog& catalog, int n);

// ---- the current

/// The motor of the axis is switched off: the console offers the switch first.
[[nodiscard]] bool powerless(const Catalog& catalog, const Snapshot& now, AxisId axis);

}  // namespace hw
