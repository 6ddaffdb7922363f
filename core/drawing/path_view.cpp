#include "core/drawing/path_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw::drawing {
namespace {

constexpr double eye_at = 3;  // times the radius of the box: like a portrait lens

Point3 times(Point3 a, Point3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// Scales each axis by the box's size, so that axes of different units get the same length.
Point3 scale_of(Point3 size, bool equal) {
  if (equal) return {1, 1, 1};
  const auto one = [](double length) { return length > 0 ? 1 / length : 1; };
  return {one(size.x), one(size.y), one(size.z)};
}

Point3 split(double degrees) {
  const double angle = degrees / 180 * std::numbers::pi;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Projection::Projection(const Box3& box, const ViewDirection& direction, bool equal)
    : pivot_(box.centre()), scale_(scale_of(box.size(), equal)) {
  nearness_ = 1 / (eye_at * std::max(length(times(box.size(), scale_)) / 2, 1e-9));
  turn(direction);
}

void Projection::turn(const ViewDirection& to) {
  direction_ = to;
  const Point3 around = split(to.turn), over = split(to.tilt);
  right_ = times({around.x, around.y, 0}, scale_);
  toward_ = times({over.x * around.y, -over.x * around.x, over.y}, scale_);
  up_ = times({-over.y * around.y, over.y * around.x, over.x}, scale_);
}

Projection Projection::turned(const ViewDirection& to) const {
  Projection other = *this;
  other.turn(to);
  return other;
}

Point3 Projection::from_plane(Point on) const {
  const Point3 d = right_ * on.x + up_ * on.y;
  return {pivot_.x + d.x / (scale_.x * scale_.x), pivot_.y + d.y / (scale_.y * scale_.y),
          pivot_.z + d.z / (scale_.z * scale_.z)};
}

bool Projection::reaches(const Box3& box) const {
  if (flat() || box.empty) return true;
  constexpr double to_the_eye = 0.75;
  for (int n = 0; n < 8; ++n)
    if (nearness_ * length(times(box.corner(n) - pivot_, scale_)) > to_the_eye) return false;
  return true;
}

PathView::PathView(const Box3& all, const Projection& projection, double width_px, double height_px,
                   bool equal)
    : projection_(projection), width_px_(std::max(width_px, 1.0)), height_px_(std::max(height_px, 1.0)) {
  constexpr double air = 0.06;
  if (all.empty) return;
  Box box;
  for (int n = 0; n < 8; ++n) box.add(projection.on_plane(all.corner(n)));
  centre_ = {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  const double whole = std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1e-9});
  const auto shown = [&](double size, double px) {
    return std::max(size, equal ? 1e-9 : whole * 1e-3) * (1 + 2 * air) / px;
  };
  per_px_ = {shown(box.high.x - box.low.x, width_px_), shown(box.high.y - box.low.y, height_px_)};
  if (equal) per_px_.x = per_px_.y = std::max(per_px_.x, per_px_.y);
}

void PathView::pan(double right_px, double down_px) {
  centre_.x -= right_px * per_px_.x;
  centre_.y += down_px * per_px_.y;
}

void PathView::zoom(Point about_px, double factor) {
  const Point kept = px_to_plane(about_px);
  const double least = 1e-12 * std::max({std::fabs(centre_.x), std::fabs(centre_.y), 1e-3});
  const double smaller = std::min(per_px_.x, per_px_.y) / factor;
  if (!(factor > 0) || smaller < least || std::max(per_px_.x, per_px_.y) / factor > 1e12) return;
  per_px_ = {per_px_.x / factor, per_px_.y / factor};
  const Point there = px_to_plane(about_px);
  centre_ = {centre_.x + kept.x - there.x, centre_.y + kept.y - there.y};
}

void PathView::resize(double width_px, double height_px) {
  const double smaller = std::min(std::max(width_px, 1.0) / width_px_, std::max(height_px, 1.0) / height_px_);
  width_px_ = std::max(width_px, 1.0), height_px_ = std::max(height_px, 1.0);
  per_px_ = {per_px_.x / smaller, per_px_.y / smaller};
}

void PathView::look(const Projection& projection, Point3 about) {
  const Point before = projection_.on_plane(about), after = projection.on_plane(about);
  projection_ = projection;
  centre_ = {centre_.x + after.x - before.x, centre_.y + after.y - before.y};
}

}  // namespace hw::drawing
