#pragma once
// Geometry of arcs and contours in their plane.
#include <optional>
#include <utility>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// End of an arc that begins at x, y. A circle ends exactly there.
std::pair<double, double> end_of(const Arc& arc, double x, double y);

struct ArcReach {
  double left, right, below, above;
};
/// Extent of an arc that begins at x, y.
ArcReach reach_of(const Arc& arc, double x, double y);
/// Unit vector of a contour's first direction; none: no step has a length.
std::optional<std::pair<double, double>> sets_off(const Contour& contour);

/// End of a contour's shape, and the unit vector of its last direction.
struct ContourEnd {
  double x = 0, y = 0, dx = 0, dy = 0;
};
/// None: no step has a length.
std::optional<ContourEnd> end_of(const Contour& contour);
/// Distance from that end to the place where the axes come to rest. `held`: speeds set by earlier Speed
/// steps. None: the ramp is unknown.
std::optional<double> runs_on_by(const Contour& contour, const Speeds& held);

}  // namespace hw::sequence
