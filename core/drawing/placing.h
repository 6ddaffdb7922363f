#pragma once
// Converts the chains of a drawing to the steps that draw them: places them on the table, and approximates
// lines and arcs for machines that cannot follow them.
#include <functional>
#include <vector>

#include "core/drawing/chains.h"
#include "core/drawing/shape.h"
#include "core/sequence/sequence.h"

namespace hw::drawing {

struct Placing {
  enum class Origin : std::uint8_t { as_drawn, lower_left, point };
  double scale = 1;  ///< units of the sequence per unit of the drawing
  Origin origin = Origin::as_drawn;
  Point point;           ///< of the drawing, placed at 0, 0
  bool swapped = false;  ///< the drawing's X follows the second axis
  bool mirrored_x = false, mirrored_y = false;
};
/// Returns the map from the drawing to the sequence.
Affine place(std::vector<Chain>& chains, const Placing& placing);
Box box_of(const std::vector<Chain>& chains);

/// How the machine follows a chain.
enum class CurveMode : std::uint8_t {
  contours,  ///< without a stop
  arcs,      ///< lines and arcs, with a stop after each
  lines,     ///< lines, with a stop after each; arcs become chords
  stairs     ///< one axis at a time
};
/// Largest distance of chords from their curve, for a total of `tolerance`: half of it for stairs, which
/// approximate the chords in turn.
constexpr double chord_within(double tolerance, CurveMode curve_mode) {
  return curve_mode == CurveMode::stairs ? tolerance / 2 : tolerance;
}
struct Tool {
  CurveMode curve_mode = CurveMode::lines;
  double tolerance = 0.01;  ///< of chords and stairs, in units of the sequence
  sequence::Speeds cutting, travel;
  std::vector<int> contour_outputs;  ///< outputs that can be switched within a contour
  int contour_pieces = 40;           ///< largest number of pieces in a contour
  [[nodiscard]] double chord() const { return chord_within(tolerance, curve_mode); }
};
/// Calls `put` with the end of each chord, in order, the last at the end of `curve`.
void chords(const Curve& curve, double tolerance, const std::function<void(Point)>& put);
/// Appends steps that draw the chains in order with the first two axes. The sequence's own routines, which
/// are not changed, lower and lift the tool. Returns the first step of each chain.
std::vector<std::size_t> draw_chains(const std::vector<Chain>& chains, const Tool& tool,
                                     sequence::Sequence& sequence);
/// Appends a drive around the box with the tool up, from its lower left corner back to that corner.
void draw_frame(const Box& box, const Tool& tool, sequence::Sequence& sequence);

}  // namespace hw::drawing
