#pragma once
// A spline of which a file gives only the points it passes through.
#include <optional>
#include <vector>

#include "core/drawing/shape.h"

namespace hw::drawing {

struct FitPoints {
  std::vector<Point> points;
  bool closed = false;
  Point start{}, end{};  ///< directions at its ends; zero: not in the file
};

/// The cubic spline through all points, continuous in curvature, parametrised by chord length, as CAD
/// programs draw it when the end directions are given. Otherwise these are taken from the nearby points. Two
/// points give a line; none: the points do not differ.
[[nodiscard]] std::optional<Shape> through(FitPoints fit);

}  // namespace hw::drawing
