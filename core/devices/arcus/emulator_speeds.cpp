#include "core/devices/arcus/emulator_speeds.h"

#include <algorithm>

namespace hw::arcus {

const SpeedRow& speed_row(const Model& model, double pulses_per_second) {
  for (const SpeedRow& row : model.speeds)
    if (pulses_per_second <= static_cast<double>(row.upper)) return row;
  return model.speeds.back();
}

std::int64_t adjusted_ms(const Model& model, const SpeedOrder& order, std::int64_t written) {
  const SpeedRow& row = speed_row(model, static_cast<double>(order.high) * order.ratio);
  // The manual's own examples need the quotient cut after the second decimal (AMB-048).
  const std::int64_t longest =
      order.high > order.low ? (order.high - order.low) * 100 / row.delta * 10 : row.min_accel_ms;
  return std::clamp(written, row.min_accel_ms, std::max(longest, row.min_accel_ms));
}

RampOrder ramps(const Model& model, const SpeedOrder& order) {
  const SpeedRow& row = speed_row(model, static_cast<double>(order.high) * order.ratio);
  const double high = static_cast<double>(order.high) * order.ratio;
  const double low =
      std::min(static_cast<double>(std::max(order.low, row.min_low_speed)) * order.ratio, high);
  const auto slope = [&](std::int64_t written) {
    const double s = static_cast<double>(adjusted_ms(model, order, written)) / 1000.0;
    return std::max(high - low, 1.0) / s;
  };
  return {Pps(high), motion::Ramp(slope(order.accel_ms), slope(order.decel_ms), Pps(low), order.shape)};
}

RampOrder ramps_over(const Model& model, const SpeedOrder& order, double pulses) {
  RampOrder found = ramps(model, order);
  const double high = found.top.value, low = found.ramp.start_speed.value;
  const auto way = [&](double slope) { return (high * high - low * low) / (2 * slope); };
  if (way(found.ramp.decel) > pulses / 2 || way(found.ramp.accel) > pulses / 2)
    found.ramp.decel = found.ramp.accel;
  return found;
}

}  // namespace hw::arcus
