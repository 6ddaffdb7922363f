#include "core/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/index.h"

namespace hw::drawing {
namespace {

constexpr double radians = std::numbers::pi / 180;

/// Adds the extreme points of an arc, where it crosses the axes of its circle.
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

bool is_same_name(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return small(x) == small(y); });
}

std::vector<int> entities_by_layer(const Drawing& drawing) {
  std::vector<std::set<int>> entities(drawing.layers.size());  // an entity may have several paths
  for (const Path& path : drawing.paths) entities[ix(path.layer)].insert(path.entity);
  std::vector<int> counts;
  for (const std::set<int>& on_it : entities) counts.push_back(static_cast<int>(on_it.size()));
  return counts;
}

std::vector<HiddenLayer> hidden_layers(const Drawing& drawing) {
  const std::vector<int> entities = entities_by_layer(drawing);
  std::vector<HiddenLayer> hidden;
  for (std::size_t i = 0; i < entities.size(); ++i)
    if (!drawing.layers[i].shown && entities[i] > 0) hidden.push_back({drawing.layers[i].name, entities[i]});
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
