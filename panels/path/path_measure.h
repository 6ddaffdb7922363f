#pragma once
// The measured line between two points of a view.
#include <optional>

#include "core/drawing/space.h"
#include "panels/path/path_overlays.h"

namespace hw::panels {

struct PathMeasure {
  bool on = false;
  std::optional<drawing::Point3> from, to;
  std::optional<drawing::Point3> pointer = {};  ///< used as the second end until that is set

  /// Sets the first end, then the second, then the first of a new line.
  void set_end(drawing::Point3 end);
  /// The vector from the first end to the second; nullopt: an end is missing.
  [[nodiscard]] std::optional<drawing::Point3> way() const;
};
void draw_measure(const PathGround& ground, const PathMeasure& measure);

}  // namespace hw::panels
