// The way that a motor still goes when stopped with its ramp: Catalog::stopping_way.
#include <algorithm>
#include <cstdlib>

#include "core/device/snapshot.h"
#include "core/devices/vxm/catalog.h"

namespace hw::vxm {

// The controller reports neither its present speed nor its S and A: they are those requested, seen, or in
// force after power-up. A motor slows down over at most the steps since its motion began, and a motion that
// slows down towards its target goes no further than that.
std::optional<double> stopping_way(const Catalog& catalog, const Snapshot& now, AxisId axis) {
  const AxisState& a = now.axes[axis.index];
  if (a.ramp <= 0 || a.activity == Activity::stopping) return {};
  const double speed = a.speed.value > 0 ? a.speed.value : catalog.jog_speed.value;
  double way = speed * speed / (2 * a.ramp);
  way = std::min(way, static_cast<double>(std::llabs((a.position - a.began_at).value)));
  if (a.has_target) way = std::min(way, static_cast<double>(std::llabs((a.target - a.position).value)));
  return way;
}

}  // namespace hw::vxm
