#include "core/devices/pmx_4ex_sa/arc_reach.h"

#include <cmath>

#include "core/sequence/arc_shape.h"

namespace hw::pmx_4ex_sa {

std::vector<AxisTarget> arc_reaches(const Snapshot& now, const std::vector<std::int64_t>& values) {
  if (values.size() < 3) return {};
  const sequence::Arc arc{static_cast<double>(values[0]), static_cast<double>(values[1]),
                          static_cast<double>(values[2]) / 1000};
  const sequence::ArcReach reach = sequence::reach_of(arc, static_cast<double>(now.axes[0].commanded().value),
                                                      static_cast<double>(now.axes[1].commanded().value));
  const auto at = [](int axis, double place) {
    return AxisTarget{AxisId{static_cast<std::uint8_t>(axis)}, Steps(std::llround(place))};
  };
  return {at(0, reach.left), at(0, reach.right), at(1, reach.below), at(1, reach.above)};
}

}  // namespace hw::pmx_4ex_sa
