#pragma once
// The rest of a sequence from a step on: first restores the state that the earlier steps leave, and brings
// the tool there without drawing. Pure.
#include <functional>
#include <string_view>

#include "core/base/result.h"
#include "core/sequence/sequence.h"

namespace hw::sequence {

/// The comment that ends the leading steps.
inline constexpr std::string_view rest_begins = "Here the rest begins.";

struct Rest {
  Sequence sequence;        ///< leading steps, then those from the given step on
  std::size_t leading = 0;  ///< number of leading steps
  /// Positions when the rest begins; none: no earlier step has moved the axis.
  Places start;
  bool leaves_homing_out = false;  ///< earlier steps home axes: the present counts are trusted instead
};

/// Whether a rehearsal shows where the rest begins, and so an error in the calculated ramp-down of contours.
/// If none does, axes are unknown after a contour that ramps down.
enum class Rehearsed : bool { no, yes };

/// Whether custom text only sets what later motions use, so that repeating it restores its effect.
using OnlySets = std::function<bool(const Custom&)>;

/// `step`: index in the list. `begin`: positions before the first step; axes named there are sent to their
/// place too. The fault says why the state before `step` is unknown: an earlier step repeats for ever, or
/// leaves an axis at a place that only the machine determines.
Result<Rest> rest_from(const Sequence& sequence, std::size_t step, const Places& begin = {},
                       Rehearsed rehearsed = Rehearsed::no, const OnlySets& only_sets = {});

/// The index of a step at which a rest can begin; for a step in a contour, that of the contour. `counted`: as
/// SequenceText counts the steps. Fault: within a loop, where the number of passes made is unknown.
Result<std::size_t> step_to_begin_at(const Sequence& sequence, int counted);

/// The leading steps for people: "Tool up. Move to X 12.5, Y 3 mm."
std::string words_of_leading(const Rest& rest);

}  // namespace hw::sequence
