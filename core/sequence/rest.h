#pragma once
// The rest of a sequence, from a step on: what the steps before it have left behind is made good first, and
// the tool comes to where it begins without drawing. Pure.
#include "core/base/result.h"
#include "core/sequence/sequence.h"

namespace hw::sequence {

struct Rest {
  Sequence sequence;        ///< the steps that lead there, then those from there on
  std::size_t leading = 0;  ///< how many of them lead there
  /// Where the axes stand when the rest begins; none: nothing before it has moved that axis.
  Places start;
  bool leaves_homing_out = false;  ///< before it axes are homed: their counts are taken for true
};

/// Whether a rehearsal tells where the rest begins, so that it will show what was worked out wrongly: how far
/// contours run on while they ramp down. Where none does, they leave their axes nobody knows where.
enum class Rehearsed : bool { no, yes };

/// `step`: a place in the list. `begin`: where the axes stand before the first step; what is named there
/// comes to its place too. The fault says why nobody can know how things stood there: what stands before it
/// repeats for ever, or leaves an axis where its machine decides.
Result<Rest> rest_from(const Sequence& sequence, std::size_t step, const Places& begin = {},
                       Rehearsed rehearsed = Rehearsed::no);

/// `counted`: as SequenceText counts the steps. Which step of the list it is, where the rest can begin there:
/// of a contour, which goes in one, the whole. The fault: it lies within a loop, of which nobody knows how
/// many rounds were made.
Result<std::size_t> step_to_begin_at(const Sequence& sequence, int counted);

/// "Tool up. Move to X 12.5, Y 3 mm.": what leads there, for people.
std::string words_of_leading(const Rest& rest);

}  // namespace hw::sequence
