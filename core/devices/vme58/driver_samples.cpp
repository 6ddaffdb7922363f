// A recording of one axis, for the tuning view: a sample of each copy of the data area that the board makes.
#include <array>
#include <optional>
#include <utility>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {

bool Vme58Driver::sampling() const { return sampled_axis_ >= 0 && now() < sample_until_; }

void Vme58Driver::sample(Instant at) {
  if (sampled_axis_ < 0 || !sample_) return;
  const AxisState& axis = draft_.axes[sampled_axis_];
  AxisSample s;
  s.at = at;
  s.axis = static_cast<std::uint8_t>(sampled_axis_);
  s.moving = moving(sampled_axis_);
  s.command = axis.command;
  s.encoder = axis.encoder;
  s.velocity = axis.speed;
  if (const auto gains = known_gains(sampled_axis_)) {
    const double steps = servo_watch_.look(*gains, catalog_.servo_update, at, s.command.value,
                                           s.encoder.value, s.velocity.value);
    s.output_percent = axis.enabled ? static_cast<float>(100 * steps / motion::output_limit) : 0;
    s.output_known = true;
  }
  sample_(s);
  if (at >= sample_until_) sampled_axis_ = -1;
}

/// None: not all of them are known. Where nothing is integrated, its interval does not matter.
std::optional<motion::ServoGains> Vme58Driver::known_gains(int axis) const {
  constexpr double hundredths = 100;
  const std::array<std::pair<std::string_view, double motion::ServoGains::*>, 6> places{{
      {"KP", &motion::ServoGains::kp},
      {"KI", &motion::ServoGains::ki},
      {"KD", &motion::ServoGains::kd},
      {"KV", &motion::ServoGains::kv},
      {"KA", &motion::ServoGains::ka},
      {"KO", &motion::ServoGains::ko},
  }};
  motion::ServoGains gains;
  std::size_t found = 0;
  bool interval_known = false;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (parameters_[i].axis != axis || !draft_.params[i].known) continue;
    const std::string_view letters = parameters_[i].fact->letters;
    const auto value = static_cast<double>(draft_.params[i].value);
    for (const auto& [name, gain] : places)
      if (letters == name) gains.*gain = value / hundredths, ++found;
    if (letters == "KN") gains.kn = static_cast<int>(value), interval_known = true;
  }
  if (found != places.size() || (gains.ki != 0 && !interval_known)) return std::nullopt;
  return gains;
}

}  // namespace hw::vme58
