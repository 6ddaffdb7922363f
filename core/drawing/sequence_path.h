#pragma once
// The tool path of a sequence, independent of a controller.
#include <array>

#include "core/drawing/tool_path.h"
#include "core/sequence/sequence.h"

namespace hw::drawing {

/// The axes of a sequence that are shown, by index, and units of the view per unit of the sequence.
struct SequenceAxes {
  int right = 0, up = 1, third = -1;  ///< third: -1: none
  Point3 scale{1, 1, 1};
  double chord = 0;  ///< distance of the machine's chords from arcs, in the sequence's unit; 0: it draws arcs
  std::array<double, max_axes> begin{};  ///< start of all its axes
};
/// A source is an index in the list. A loop is run through once; its steps have the loop's index.
ToolPath sequence_path_in(const sequence::Sequence& sequence, const SequenceAxes& axes);
/// The first two axes, from 0, 0.
inline ToolPath sequence_path(const sequence::Sequence& sequence, Point scale, double chord = 0) {
  return sequence_path_in(sequence, {0, 1, -1, scale, chord, {}});
}

}  // namespace hw::drawing
