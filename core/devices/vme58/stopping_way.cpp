// Distance that an axis still travels when it is stopped with its ramp: Catalog::stopping_way.
#include <algorithm>
#include <string>

#include "core/device/snapshot.h"
#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {

std::optional<double> stopping_way(const Catalog& c, const Snapshot& now, AxisId axis) {
  const int i = c.find_param("AC" + c.axes[axis.index].name);
  const double speed = now.axes[axis.index].speed.value;
  if (i < 0 || speed <= 0) return {};
  const ParamState& rate = now.params[static_cast<std::size_t>(i)];
  if (!rate.known || rate.value <= 0) return {};
  const int b = c.find_param("VB" + c.axes[axis.index].name);
  const ParamState* base = b < 0 ? nullptr : &now.params[static_cast<std::size_t>(b)];
  // Below the base velocity it stops without a ramp.
  const double last = base && base->known ? static_cast<double>(base->value) : 0;
  return std::max(0.0, (speed * speed - last * last) / (2 * static_cast<double>(rate.value)));
}

}  // namespace hw::vme58
