#pragma once
// Where a tool goes in two or three axes, to be looked at: in the units of the axes, each part with what it
// comes from. Pure.
#include <cstddef>
#include <optional>
#include <vector>

#include "core/drawing/path_view.h"

namespace hw::drawing {

struct ToolPath {
  /// Without a break, all of it with the tool on or off, and from one source.
  struct Run {
    std::size_t first = 0, size = 0;  ///< its points; the first may be the last of the run before
    bool tool_on = true;
    int source = -1;  ///< line of a program or step of a list, from 0; -1: not known
    int pass = 0;     ///< of a source that is gone through several times
  };
  std::vector<Point3> points;
  std::vector<Run> runs;
  Box3 bounds;
  double way_on = 0, way_off = 0;  ///< with the tool on and off

  /// Goes on to `to` from `from`. Straight on in the same run it only becomes longer.
  void go(Point3 from, Point3 to, bool tool_on, int source, int pass = 0);
};

struct PathHit {
  std::size_t run = 0;
  Point3 at;  ///< on the path
};
/// What of the path lies nearest to a pixel, and no further from it than `within_px`.
std::optional<PathHit> nearest(const ToolPath& path, const PathView& view, Point px, double within_px);

/// The same way in few lines, for a glance: what is small against the whole of it is passed over.
ToolPath coarser(const ToolPath& path, std::size_t most_points);
/// As it looks from there: in the plane that is looked at.
ToolPath flattened(const ToolPath& path, const Projection& projection);

}  // namespace hw::drawing
