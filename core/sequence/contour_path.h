#pragma once
// The path of a contour, to be drawn: in the sequence's own unit, arcs as many short lines.
#include <cstddef>
#include <vector>

#include "core/sequence/sequence.h"

namespace hw::sequence {

struct PathPoint {
  double x = 0, y = 0;
};
struct ContourPath {
  PathPoint park;  ///< where the lead-in begins
  struct Leg {
    std::size_t first = 0, size = 0;  ///< its points, the first of them the end of the leg before
    std::size_t step = 0;             ///< in Contour::steps
    int outputs_on = 0;               ///< how many are on while it is drawn
  };
  std::vector<PathPoint> points;
  std::vector<Leg> legs;
  double length = 0;  ///< without lead-in
};
/// What has no length or makes no sense is passed over: whoever writes it tells why.
ContourPath contour_path(const Contour& contour);

}  // namespace hw::sequence
