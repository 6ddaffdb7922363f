#pragma once
// The measured line between two points of a view.
#include <optional>

#include "core/drawing/space.h"
#include "panels/path/path_overlays.h"

namespace hw::panels {

struct PathMeasure {
  bool on = false;
  std::optional<drawing::Point3> from, to;
  std::optional<drawing::Point3> pointer = {};  ///< stands in for the second end until it is set

  /// Sets the first end, then the second, then the first of a new line.
  void set_end(drawing::Point3 end);
  /// From the first end to the second; none: an end is missing.
  [[nodiscard]] std::optional<drawing::Point3> way() const;
};
void draw_measure(const PathGround& ground, const PathMeasure& measure);

}  // namespace hw::panels
