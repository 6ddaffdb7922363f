#include "core/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/index.h"

namespace hw::drawing {
namespace {

constexpr double radians = std::numbers::pi / 180;

/// The outermost points of an arc on its way: where it crosses the axes of its circle.
void add_quarters(Box& box, const Curve& arc) {
  const double radius = std::hypot(arc.from.x - arc.centre.x, arc.from.y - arc.centre.y);
  const double begin = std::atan2(arc.from.y - arc.centre.y, arc.from.x - arc.centre.x) / radians;
  const double low = std::min(begin, begin + arc.degrees), high = std::max(begin, begin + arc.degrees);
  for (double at = std::ceil(low / 90) * 90; at <= high; at += 90)
    box.add({arc.centre.x + radius * std::cos(at * radians), arc.centre.y + radius * std::sin(at * radians)});
}

}  // namespace

double Curve::length() const {
  if (kind == Kind::line) return std::hypot(to.x - from.x, to.y - from.y);
  return std::hypot(from.x - centre.x, from.y - centre.y) * std::fabs(degrees) * radians;
}

bool Path::closed() const {
  return !curves.empty() && curves.front().from == curves.back().to &&
         (curves.size() > 1 || curves[0].degrees != 0);
}

void Box::add(Point p) {
  low = empty ? p : Point{std::min(low.x, p.x), std::min(low.y, p.y)};
  high = empty ? p : Point{std::max(high.x, p.x), std::max(high.y, p.y)};
  empty = false;
}

void Box::add(const Curve& curve) {
  add(curve.from);
  add(curve.to);
  if (curve.kind == Curve::Kind::arc) add_quarters(*this, curve);
}

std::vector<HiddenLayer> hidden_layers(const Drawing& drawing) {
  std::vector<std::set<int>> entities(drawing.layers.size());  // one may draw more than one path
  for (const Path& path : drawing.paths) entities[ix(path.layer)].insert(path.entity);
  std::vector<HiddenLayer> hidden;
  for (std::size_t i = 0; i < entities.size(); ++i)
    if (!drawing.layers[i].shown && !entities[i].empty())
      hidden.push_back({drawing.layers[i].name, static_cast<int>(entities[i].size())});
  return hidden;
}

Box box_of(const Drawing& drawing) {
  Box box;
  for (const Path& path : drawing.paths)
    for (const Curve& curve : path.curves) box.add(curve);
  return box;
}

double length_of(const Drawing& drawing) {
  double length = 0;
  for (const Path& path : drawing.paths)
    for (const Curve& curve : path.curves) length += curve.length();
  return length;
}

}  // namespace hw::drawing
