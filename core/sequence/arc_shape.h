#pragma once
// Where an arc goes, and a contour sets off, as seen in its plane.
#include <optional>
#include <utility>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Where it ends if it begins at x, y. A circle ends exactly there.
std::pair<double, double> end_of(const Arc& arc, double x, double y);

struct ArcReach {
  double left, right, below, above;
};
/// The least and the greatest places that it comes to if it begins at x, y.
ArcReach reach_of(const Arc& arc, double x, double y);
/// The direction, of length 1, in which a contour begins; none: none of its steps has a length.
std::optional<std::pair<double, double>> sets_off(const Contour& contour);

/// Where the shape of a contour ends, and the direction, of length 1, in which it does.
struct ContourEnd {
  double x = 0, y = 0, dx = 0, dy = 0;
};
/// None: none of its steps has a length.
std::optional<ContourEnd> end_of(const Contour& contour);
/// How far on it comes to rest behind that. `held`: what speed steps before it have said. None: they do not
/// say how its axes ramp.
std::optional<double> runs_on_by(const Contour& contour, const Speeds& held);

}  // namespace hw::sequence
