#pragma once
// A way between two points of a view, measured.
#include <optional>

#include "core/drawing/space.h"
#include "panels/path/path_overlays.h"

namespace hw::panels {

struct PathMeasure {
  bool on = false;
  std::optional<drawing::Point3> from, to;
  std::optional<drawing::Point3> pointer = {};  ///< taken for its second end until that is set

  /// The first end, then the second, then the first of another.
  void set_end(drawing::Point3 end);
  /// From its first end to the second; none: it has not both.
  [[nodiscard]] std::optional<drawing::Point3> way() const;
};
void draw_measure(const PathGround& ground, const PathMeasure& measure);

}  // namespace hw::panels
