#pragma once
// The view of a path: direction, distance, and the part shown in so many pixels. Pure.
#include "core/drawing/space.h"

namespace hw::drawing {

/// Direction of view: 0, 0 is from the front, along the second axis, with the third upwards.
struct ViewDirection {
  double turn = 0;  ///< degrees about the third axis; 90: from the right side
  double tilt = 0;  ///< degrees upwards; 90: from the top, -90: from below
  bool operator==(const ViewDirection&) const = default;
};
namespace views {
inline constexpr ViewDirection top{0, 90}, front{0, 0}, side{90, 0}, iso{45, 35.264389682754654};
}

/// Projects the axes to the view plane: in perspective, or for two axes unchanged, their plane seen from far
/// away.
class Projection {
 public:
  Projection() = default;
  /// Around the middle of `box`, from far enough that all of it is in front of the eye. `equal`: the axes
  /// have the same unit; otherwise each is scaled to the same length.
  Projection(const Box3& box, const ViewDirection& direction, bool equal);

  [[nodiscard]] Point on_plane(Point3 p) const {
    const Point3 d = p - pivot_;
    const double w = depth(p);
    return {dot(right_, d) / w, dot(up_, d) / w};
  }
  /// Distance from the eye relative to the pivot's; 1 everywhere for a distant eye.
  [[nodiscard]] double depth(Point3 p) const {
    const double w = 1 - nearness_ * dot(toward_, p - pivot_);
    return w > least_depth ? w : least_depth;
  }
  /// The point at the pivot's depth.
  [[nodiscard]] Point3 from_plane(Point on) const;
  /// Two axes, unchanged.
  [[nodiscard]] bool flat() const { return nearness_ == 0; }
  [[nodiscard]] const ViewDirection& from() const { return direction_; }
  /// The same pivot from another direction. Three axes only.
  [[nodiscard]] Projection turned(const ViewDirection& to) const;
  /// Whether all of `box` is drawn correctly.
  [[nodiscard]] bool reaches(const Box3& box) const;
  bool operator==(const Projection&) const = default;

 private:
  void turn(const ViewDirection& to);
  static constexpr double least_depth = 0.1;  // nothing nearer is drawn correctly

  ViewDirection direction_ = views::top;
  Point3 pivot_, scale_{1, 1, 1};
  Point3 right_{1, 0, 0}, up_{0, 1, 0}, toward_{0, 0, 1};  ///< times `scale_`
  double nearness_ = 0;                                    ///< 1 / distance of the eye
};

/// A part of that plane in so many pixels, y upwards.
class PathView {
 public:
  PathView() = default;
  /// Shows all of `box` with a margin. `equal`: a circle stays a circle.
  PathView(const Box3& box, const Projection& projection, double width_px, double height_px, bool equal);
  /// Two axes, unchanged.
  PathView(const Box3& box, double width_px, double height_px, bool equal)
      : PathView(box, Projection(), width_px, height_px, equal) {}

  [[nodiscard]] Point to_px(Point3 p) const { return plane_to_px(projection_.on_plane(p)); }
  /// The point at a pixel; for three axes the one at the pivot's depth.
  [[nodiscard]] Point3 from_px(Point px) const { return projection_.from_plane(px_to_plane(px)); }
  /// The pixel here of the point at `px` in `other`, a view of the same projection.
  [[nodiscard]] Point moved_px(const PathView& other, Point px) const {
    return plane_to_px(other.px_to_plane(px));
  }
  [[nodiscard]] const Projection& projection() const { return projection_; }
  [[nodiscard]] bool flat() const { return projection_.flat(); }
  [[nodiscard]] Point per_px() const { return per_px_; }
  [[nodiscard]] double width_px() const { return width_px_; }
  [[nodiscard]] double height_px() const { return height_px_; }

  void pan(double right_px, double down_px);
  /// The point at `about` stays there. `factor` > 1: nearer. Limited to what a double can resolve.
  void zoom(Point about_px, double factor);
  /// The same part, in another size.
  void resize(double width_px, double height_px);
  /// Changes the projection; `about` stays where it is on the screen.
  void look(const Projection& projection, Point3 about);
  bool operator==(const PathView&) const = default;

 private:
  [[nodiscard]] Point plane_to_px(Point p) const {
    return {width_px_ / 2 + (p.x - centre_.x) / per_px_.x, height_px_ / 2 - (p.y - centre_.y) / per_px_.y};
  }
  [[nodiscard]] Point px_to_plane(Point px) const {
    return {centre_.x + (px.x - width_px_ / 2) * per_px_.x, centre_.y - (px.y - height_px_ / 2) * per_px_.y};
  }

  Projection projection_;
  Point centre_, per_px_{1, 1};
  double width_px_ = 1, height_px_ = 1;
};

}  // namespace hw::drawing
