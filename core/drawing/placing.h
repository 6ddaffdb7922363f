#pragma once
// From the chains of a drawing to the steps that draw them: where they come to lie on the table, and what is
// made of lines and arcs for a machine that cannot go along them.
#include <functional>
#include <vector>

#include "core/drawing/chains.h"
#include "core/drawing/shape.h"
#include "core/sequence/sequence.h"

namespace hw::drawing {

struct Placing {
  enum class Origin : std::uint8_t { as_drawn, lower_left, point };
  double scale = 1;  ///< units of the sequence in one of the drawing
  Origin origin = Origin::as_drawn;
  Point point;           ///< of the drawing, that comes to lie at 0, 0
  bool swapped = false;  ///< the drawing's X goes along the second axis
  bool mirrored_x = false, mirrored_y = false;
};
/// Returns how: from the drawing to the sequence.
Affine place(std::vector<Chain>& chains, const Placing& placing);
Box box_of(const std::vector<Chain>& chains);

/// How the machine gets along a chain.
enum class Going : std::uint8_t {
  contours,  ///< in one go
  arcs,      ///< by lines and arcs, with a stop between
  lines,     ///< by lines, with a stop between; arcs become chords
  stairs     ///< one axis at a time
};
/// How far chords may lie beside their curve, where all together may lie `tolerance` beside it: stairs take
/// half of that, as their lines are chords of it too.
constexpr double chord_within(double tolerance, Going going) {
  return going == Going::stairs ? tolerance / 2 : tolerance;
}
struct Tool {
  Going going = Going::lines;
  double tolerance = 0.01;  ///< of chords and stairs, in units of the sequence
  sequence::Speeds cutting, travel;
  std::vector<int> contour_outputs;  ///< that can be switched within a contour
  int contour_pieces = 40;           ///< that a contour holds
  [[nodiscard]] double chord() const { return chord_within(tolerance, going); }
};
/// Where the tool has to be, or `way` between, told from the begin on. Lines longer than nothing only.
void chords(const Curve& curve, double tolerance, const std::function<void(Point)>& put);
/// The first two axes go along the chains in their order; the tool is lowered and raised by the sequence's
/// own routines, which stay as they are. Returns at which of the sequence's steps each chain begins.
std::vector<std::size_t> draw_chains(const std::vector<Chain>& chains, const Tool& tool,
                                     sequence::Sequence& sequence);
/// Once around it with the tool up, from its lower left corner back to there.
void draw_frame(const Box& box, const Tool& tool, sequence::Sequence& sequence);

}  // namespace hw::drawing
