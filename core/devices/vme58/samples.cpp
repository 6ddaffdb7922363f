#include "core/devices/vme58/samples.h"

namespace hw::vme58 {

void Samples::start(const intent::Sample& request) {
  const bool on = request.length.count() > 0 && request.axis.index < static_cast<int>(catalog_.axes.size());
  axis_ = on ? request.axis.index : -1;
  until_ = wire_.now() + request.length;
  watch_.start();
}

void Samples::take(Instant at) {
  if (axis_ < 0 || !sample_) return;
  const AxisState& axis = snapshot_.axes[axis_];
  AxisSample s;
  s.at = at;
  s.axis = static_cast<std::uint8_t>(axis_);
  s.moving = readings_.moving(axis_);
  s.command = axis.command;
  s.encoder = axis.encoder;
  s.velocity = axis.speed;
  if (const auto gains = values_.gains(axis_)) {
    const double steps =
        watch_.look(*gains, catalog_.servo_update, at, s.command.value, s.encoder.value, s.velocity.value);
    s.output_percent = axis.enabled ? static_cast<float>(100 * steps / motion::output_limit) : 0;
    s.output_known = true;
  }
  sample_(s);
  if (at >= until_) axis_ = -1;
}

}  // namespace hw::vme58
