#pragma once
// Where a tool goes in two axes, to be looked at: in the units of the axes, each part with what it comes
// from. Pure.
#include <cstddef>
#include <optional>
#include <vector>

#include "core/drawing/drawing.h"

namespace hw::drawing {

struct ToolPath {
  /// Without a break, all of it with the tool on or off, and from one source.
  struct Run {
    std::size_t first = 0, size = 0;  ///< its points; the first may be the last of the run before
    bool tool_on = true;
    int source = -1;  ///< line of a program or step of a list, from 0; -1: not known
  };
  std::vector<Point> points;
  std::vector<Run> runs;
  Box bounds;
  double way_on = 0, way_off = 0;  ///< with the tool on and off

  /// Goes on to `to` from `from`. Straight on in the same run it only becomes longer.
  void go(Point from, Point to, bool tool_on, int source);
};

/// How a part of a plane is shown in so many pixels, y upwards.
class PathView {
 public:
  PathView() = default;
  /// Shows all of `box`, with air around. `equal`: a circle stays one.
  PathView(const Box& box, double width_px, double height_px, bool equal);

  [[nodiscard]] Point to_px(Point p) const {
    return {width_px_ / 2 + (p.x - centre_.x) / per_px_.x, height_px_ / 2 - (p.y - centre_.y) / per_px_.y};
  }
  [[nodiscard]] Point from_px(Point px) const {
    return {centre_.x + (px.x - width_px_ / 2) * per_px_.x, centre_.y - (px.y - height_px_ / 2) * per_px_.y};
  }
  [[nodiscard]] Point per_px() const { return per_px_; }
  [[nodiscard]] double width_px() const { return width_px_; }
  [[nodiscard]] double height_px() const { return height_px_; }

  void pan(double right_px, double down_px);
  /// What lies at `about` stays there. `factor` > 1: nearer. Not beyond what can be told apart in a double.
  void zoom(Point about_px, double factor);
  /// The same part, in another size.
  void resize(double width_px, double height_px);
  bool operator==(const PathView&) const = default;

 private:
  Point centre_, per_px_{1, 1};
  double width_px_ = 1, height_px_ = 1;
};

struct PathHit {
  std::size_t run = 0;
  Point at;  ///< on the path
};
/// What of the path lies nearest to a pixel, and no further from it than `within_px`.
std::optional<PathHit> nearest(const ToolPath& path, const PathView& view, Point px, double within_px);

}  // namespace hw::drawing
