#pragma once
// A spline of which a file only says through which points it goes.
#include <optional>
#include <vector>

#include "core/drawing/shape.h"

namespace hw::drawing {

struct FitPoints {
  std::vector<Point> points;
  bool closed = false;
  Point start, end;  ///< directions at its ends; no length: the file does not say them
};

/// The cubic through all of them, smooth to its curvature, with the lengths of the chords as its parameter:
/// as CAD programs draw it where the directions at its ends are said. Else they are those of the points
/// nearby. A line through two points; none where they do not differ.
[[nodiscard]] std::optional<Shape> through(FitPoints fit);

}  // namespace hw::drawing
