#pragma once
// The path of a tool in two or three axes, for display: in the units of the axes, each part with its source.
// Pure.
#include <cstddef>
#include <optional>
#include <vector>

#include "core/drawing/path_view.h"

namespace hw::drawing {

struct ToolPath {
  /// A continuous part with one tool state and one source.
  struct Run {
    std::size_t first = 0, size = 0;  ///< its points; the first may be the last of the previous run
    bool tool_on = true;
    int source = -1;  ///< line of a program or step of a list, from 0; -1: not known
    int pass = 0;     ///< of a source that is run several times
  };
  std::vector<Point3> points;
  std::vector<Run> runs;
  Box3 bounds;
  double way_on = 0, way_off = 0;  ///< with the tool on and off

  /// Appends a line. A straight continuation of the same run only lengthens its last line.
  void go(Point3 from, Point3 to, bool tool_on, int source, int pass = 0);
};

struct PathHit {
  std::size_t run = 0;
  Point3 at;  ///< on the path
};
/// The point of the path nearest to a pixel; none within `within_px`: none.
std::optional<PathHit> nearest(const ToolPath& path, const PathView& view, Point px, double within_px);

/// The same path in few lines, for a preview: details small against the whole are dropped.
ToolPath coarser(const ToolPath& path, std::size_t most_points);
/// The path projected to the view plane.
ToolPath flattened(const ToolPath& path, const Projection& projection);

}  // namespace hw::drawing
