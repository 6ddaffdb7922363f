// Power and non-volatile memory. What STORE keeps comes back at power-up; device number, line rate, line type
// and reply format are taken from flash then and only then (decision AMB-012).
#include <algorithm>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

Controller::Controller(const Model& model)
    : model_(&model), flash_(model), settings_(model), axes_(static_cast<std::size_t>(model.axes())) {
  constexpr std::int32_t middle_mv = 2500;
  terminals_.analog.fill(middle_mv);
  for (Axis& axis : axes_) {
    axis.counts_per_pulse =
        static_cast<double>(model.counts_numerator) / static_cast<double>(model.counts_denominator);
    axis.index_every = model.index_every;
    axis.index_first = model.index_every / 2;
  }
  power_up();
}

void Controller::power_down() {
  bring_up_to_date();
  for (Motion& m : motions_) m = Motion();
  for (Axis& axis : axes_) axis.slot = -1;
  powered_ = false;
}

void Controller::power_up() {
  powered_ = true;
  settings_.reset(true);
  settings_.take_stored(flash_.settings);
  for (Motion& m : motions_) m = Motion();
  buffer_ = MoveBuffer();
  incremental_ = false;
  joystick_ = JoystickTurns();
  timeout_.forget();
  timer_end_ = Instant{};
  terminals_.outputs = settings_.get(Setting::boot_outputs);
  terminals_.enables = settings_.get(Setting::boot_enables);
  host_settings_.take(settings_);
  for (Axis& axis : axes_) {
    Axis fresh;
    fresh.plant = axis.plant, fresh.counts_per_pulse = axis.counts_per_pulse;
    fresh.index_every = axis.index_every, fresh.index_first = axis.index_first;
    fresh.alarm_operated = axis.alarm_operated, fresh.jammed_by_hand = axis.jammed_by_hand;
    axis = fresh;
    axis.set_encoder(0);
  }
  hold_loads();
  command_answered(false);
  if (settings_.get(Setting::joystick) != 0) schedule_joystick();
  programs_power_up();
}

void Controller::store() {
  flash_.settings.take_stored(settings_);
  for (int n = first_stored_variable; n < variables; ++n) flash_.values[ix(n)] = vm_.variable(n);
  ++flash_.stores;
}

std::string Controller::saved_text() const {
  std::string text = "# Non-volatile memory of a " + std::string(model_->title) +
                     "\nstores = " + std::to_string(flash_.stores) + "\n";
  flash_.settings.append_stored(text);
  for (int n = first_stored_variable; n < variables; ++n)
    text += "V" + std::to_string(n) + "=" + std::to_string(flash_.values[ix(n)]) + "\n";
  for (int line = 0; line < program_lines; ++line)
    if (!flash_.program[ix(line)].empty())
      text += "SA" + std::to_string(line) + "=" + flash_.program[ix(line)] + "\n";
  return text;
}

std::string Controller::load_line(std::string_view line) {
  const auto numbered = [&](std::string_view head, int count) -> std::optional<int> {
    const auto equals = line.find('=');
    if (line.substr(0, head.size()) != head || equals == std::string_view::npos) return std::nullopt;
    const auto n = parse_integer(line.substr(head.size(), equals - head.size()));
    if (!n || *n < 0 || *n >= count) return std::nullopt;
    return static_cast<int>(*n);
  };
  constexpr std::string_view stores = "stores = ";
  if (line.substr(0, stores.size()) == stores) {
    const auto n = parse_integer(line.substr(stores.size()));
    if (!n || *n < 0) return "has no valid number of stores";
    flash_.stores = static_cast<std::uint64_t>(*n);
    return {};
  }
  const std::string_view value = line.substr(std::min(line.find('=') + 1, line.size()));
  if (const auto n = numbered("SA", program_lines)) {
    if (value.size() > static_cast<std::size_t>(max_line_text)) return "is too long for a program line";
    flash_.program[ix(*n)] = value;
    return {};
  }
  if (const auto n = numbered("V", variables)) {
    const auto v = parse_integer(value);
    if (!v || *v < INT32_MIN || *v > INT32_MAX) return "has no valid 32-bit number";
    flash_.values[ix(*n)] = static_cast<std::int32_t>(*v);
    return {};
  }
  if (flash_.settings.load_line(line)) return {};
  return "is unknown: " + std::string(line.substr(0, 40));
}

}  // namespace hw::arcus
