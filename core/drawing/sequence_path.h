#pragma once
// The way that a sequence says its tool goes, before any controller has it.
#include <array>

#include "core/drawing/tool_path.h"
#include "core/sequence/sequence.h"

namespace hw::drawing {

/// Which axes of a sequence are seen, by their places in it, and units of the view in one of the sequence's.
struct SequenceAxes {
  int right = 0, up = 1, third = -1;  ///< third: -1: none
  Point3 scale{1, 1, 1};
  double chord =
      0;  ///< how far the machine's chords lie beside arcs, in the sequence's unit; 0: it draws arcs
  std::array<double, max_axes> begin{};  ///< where all of its axes stand at first
};
/// A source is a place in the list; what is in a loop is gone through once, with the place of the
/// loop.
ToolPath sequence_path_in(const sequence::Sequence& sequence, const SequenceAxes& axes);
/// In its first two axes, from 0, 0.
inline ToolPath sequence_path(const sequence::Sequence& sequence, Point scale, double chord = 0) {
  return sequence_path_in(sequence, {0, 1, -1, scale, chord, {}});
}

}  // namespace hw::drawing
