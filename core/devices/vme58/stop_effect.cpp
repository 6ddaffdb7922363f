#include "core/devices/vme58/stop_effect.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/index.h"

namespace hw::vme58 {
namespace {

constexpr Duration effect_time = Millis(60);  // so that a stop without effect is seen within 100 ms
constexpr Duration kill_time = std::chrono::seconds(2);  // KL is repeated for this long
constexpr double longest_shape = 3;  // a PN10 ramp relative to a straight one, and a margin
constexpr Duration ramp_margin = std::chrono::seconds(1);

}  // namespace

StopEffect::Seen StopEffect::look(int axis, bool at_once) {
  const Instant now = wire_.now();
  Seen all;
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i) {
    if ((axis >= 0 && i != axis) || !motions_.moving(i)) continue;
    const SlowDown& seen = look_at(i);
    all.turns = true;
    all.slows = all.slows || now - seen.slower_at <= effect_patience(i, seen);
    const Duration extra = at_once ? kill_time : Duration::zero();
    all.overdue = all.overdue || now - seen.since > longest_ramp(i, seen) + extra;
  }
  return all;
}

const StopEffect::SlowDown& StopEffect::look_at(int axis) {
  const std::int64_t speed = std::abs(readings_.value(axis, AxisValue::command_velocity));
  std::optional<SlowDown>& seen = axes_[ix(axis)];
  if (!seen) seen = SlowDown{wire_.now(), wire_.now(), speed, speed};
  if (speed < seen->least) {
    seen->least = speed;
    seen->slower_at = wire_.now();
  }
  return *seen;
}

void StopEffect::stop_sent(int axis) {
  if (axes_[ix(axis)]) axes_[ix(axis)]->slower_at = wire_.now();
}

void StopEffect::forget(int axis) {
  for (int i = 0; i < most_axes; ++i)
    if (axis < 0 || i == axis) axes_[ix(i)].reset();
}

double StopEffect::acceleration(int axis) const {
  return static_cast<double>(std::max<std::int64_t>(1, readings_.value(axis, AxisValue::acceleration)));
}

/// How long a slowing axis may show no loss of speed: the board shows whole counts/s, and a rounded ramp (PN,
/// CN) begins and ends gently.
Duration StopEffect::effect_patience(int axis, const SlowDown& seen) const {
  return effect_time +
         from_seconds((20 + 2 * std::sqrt(static_cast<double>(seen.first))) / acceleration(axis));
}

Duration StopEffect::longest_ramp(int axis, const SlowDown& seen) const {
  return ramp_margin + from_seconds(longest_shape * static_cast<double>(seen.first) / acceleration(axis));
}

}  // namespace hw::vme58
