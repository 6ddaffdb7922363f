#include "core/drawing/space.h"

#include <algorithm>
#include <cmath>

namespace hw::drawing {

double length(Point3 p) { return std::hypot(p.x, p.y, p.z); }

void Box3::add(Point3 p) {
  if (empty) {
    low = high = p;
    empty = false;
    return;
  }
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void Box3::add(const Box3& box) {
  if (!box.empty) add(box.low), add(box.high);
}

}  // namespace hw::drawing
