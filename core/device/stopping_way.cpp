#include "core/device/stopping_way.h"

#include <algorithm>
#include <cstdlib>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"

namespace hw {

std::optional<double> stopping_way_by_ramp(const Catalog& catalog, const Snapshot& now, AxisId axis) {
  const AxisState& a = now.axes[axis.index];
  if (a.ramp <= 0 || a.activity == Activity::stopping) return {};
  const double speed = a.speed.value > 0 ? a.speed.value : catalog.jog_speed.value;
  double way = speed * speed / (2 * a.ramp);
  way = std::min(way, static_cast<double>(std::llabs((a.position - a.began_at).value)));
  if (a.has_target) way = std::min(way, static_cast<double>(std::llabs((a.target - a.position).value)));
  return way;
}

}  // namespace hw
