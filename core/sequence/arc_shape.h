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

}  // namespace hw::sequence
