#include "core/devices/arcus/emulator_program_host.h"

#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

using language::Outcome;
using language::Quantity;

namespace {

/// For a motion: it waits for its axis (decision AMB-113).
Outcome outcome_of(Refusal refusal) {
  if (refusal == Refusal::none) return Outcome::done;
  return refusal == Refusal::moving ? Outcome::busy : Outcome::error;
}

/// For a value: what a host would be refused is a program error (decisions AMB-113, AMB-118).
Outcome outcome_of_value(Refusal refusal) {
  return refusal == Refusal::none ? Outcome::done : Outcome::error;
}

const language::Dialect& dialect_of(const Model& model) {
  const language::Dialect& pmx = language::pmx_4ex_sa();
  return pmx.model == model.name ? pmx : language::dmx_k_sa();
}

std::int32_t narrow(std::int64_t v) { return static_cast<std::int32_t>(v); }

/// Quantities that are settings, and which of several.
struct SettingRow {
  Quantity quantity;
  Setting setting;
  int offset = 0;  ///< of the index within the setting (joystick groups), times
  int stride = 1;
};
constexpr SettingRow setting_rows[] = {
    {Quantity::acceleration, Setting::accel},
    {Quantity::deceleration, Setting::decel},
    {Quantity::high_speed, Setting::high_speed},
    {Quantity::low_speed, Setting::low_speed},
    {Quantity::axis_acceleration, Setting::axis_accel},
    {Quantity::axis_deceleration, Setting::axis_decel},
    {Quantity::axis_high_speed, Setting::axis_high_speed},
    {Quantity::axis_low_speed, Setting::axis_low_speed},
    {Quantity::s_curve, Setting::s_curve},
    {Quantity::loop_enable, Setting::loop},
    {Quantity::speed_window, Setting::speed_window},
    {Quantity::comm_timeout, Setting::comm_timeout},
    {Quantity::sync_condition, Setting::sync_condition},
    {Quantity::sync_position, Setting::sync_position},
    {Quantity::sync_time, Setting::sync_width},
    {Quantity::joystick_axes, Setting::joystick},
    {Quantity::joystick_speed, Setting::joystick_values, 0},
    {Quantity::joystick_delta, Setting::joystick_values, 4},
    {Quantity::joystick_minus_outer, Setting::joystick_limits, 0, 4},
    {Quantity::joystick_minus_inner, Setting::joystick_limits, 1, 4},
    {Quantity::joystick_plus_inner, Setting::joystick_limits, 2, 4},
    {Quantity::joystick_plus_outer, Setting::joystick_limits, 3, 4},
    {Quantity::run_current, Setting::run_current},
    {Quantity::idle_current, Setting::idle_current},
};

const SettingRow* setting_row(Quantity quantity) {
  for (const SettingRow& row : setting_rows)
    if (row.quantity == quantity) return &row;
  return nullptr;
}

}  // namespace

std::int32_t ProgramHost::read(Quantity quantity, int index) const {
  if (const SettingRow* row = setting_row(quantity))
    return narrow(seen_.read_setting(row->setting, row->offset + index * row->stride));
  switch (quantity) {
    case Quantity::pulse_position: return narrow(seen_.position(index));
    case Quantity::encoder_position: return narrow(seen_.encoder(index));
    case Quantity::speed: return narrow(seen_.speed(index));
    case Quantity::motor_status: return narrow(seen_.status(index));
    case Quantity::loop_state: return static_cast<std::int32_t>(seen_.loop_state(index));
    case Quantity::inputs: return noted("DI", narrow(seen_.inputs()));
    case Quantity::input:
      return noted("DI" + std::to_string(index), narrow(seen_.inputs() >> (index - 1) & 1));
    case Quantity::outputs: return narrow(seen_.outputs());
    case Quantity::output: return narrow(seen_.outputs() >> (index - 1) & 1);
    case Quantity::enables: return narrow(seen_.enables());
    case Quantity::enable: return narrow(seen_.enables() >> (index - 1) & 1);
    case Quantity::analog: return noted("AI" + std::to_string(index), narrow(seen_.analog(index)));
    case Quantity::timer: return narrow(seen_.timer_ms());
    case Quantity::sync_state: return seen_.sync_state(index);
    case Quantity::latch_state: return seen_.latch(index).state;
    case Quantity::latch_encoder: return narrow(seen_.latch(index).encoder);
    case Quantity::latch_pulse: return narrow(seen_.latch(index).pulses);
    default: return 0;
  }
}

std::int32_t ProgramHost::noted(const std::string& input, std::int32_t value) const {
  const bool statement_reads = seen_.trace != nullptr && seen_.vm().line_at_work() >= 0;
  if (statement_reads && controller_ != nullptr) controller_->note_read(input, value);
  return value;
}

Outcome ProgramHost::write(Quantity quantity, int index, std::int32_t value) {
  if (const SettingRow* row = setting_row(quantity)) {
    const SettingFact* fact = seen_.settings().fact(row->setting);
    const bool fits =
        fact != nullptr && ((value >= fact->min && value <= fact->max) || (value == 0 && fact->also_zero));
    if (!fits) return Outcome::error;
    return outcome_of_value(
        controller_->write_setting(row->setting, value, row->offset + index * row->stride));
  }
  if (quantity == Quantity::new_speed) {  // never refused in a program (decision AMB-058)
    if (!seen_.settings().on(Setting::s_curve, index)) (void)controller_->change_speed(index, value);
    return Outcome::done;
  }
  // A register accepts the same values from a program as from a host (decisions AMB-062, AMB-118).
  if (!can_hold(dialect_of(seen_.model()), quantity, value)) return Outcome::error;
  constexpr int ms_per_idle_unit = 10;  // decision AMB-096
  switch (quantity) {
    case Quantity::pulse_position: return outcome_of_value(controller_->set_position(index, value));
    case Quantity::encoder_position: return outcome_of_value(controller_->set_encoder(index, value));
    case Quantity::outputs: controller_->set_outputs(value); return Outcome::done;
    case Quantity::output: controller_->set_output(index, value != 0); return Outcome::done;
    case Quantity::enables: controller_->set_enables(value); return Outcome::done;
    case Quantity::enable: controller_->set_enable(index, value != 0); return Outcome::done;
    case Quantity::timer: controller_->set_timer(value); return Outcome::done;
    case Quantity::latch_enable: controller_->arm_latch(index, value != 0); return Outcome::done;
    case Quantity::idle_delay:
      return outcome_of_value(controller_->write_setting(Setting::idle_time, value * ms_per_idle_unit, 0));
    default: return Outcome::error;
  }
}

Outcome ProgramHost::move(const language::Move& move) {
  Targets targets;
  for (int a = 0; a < seen_.axes(); ++a)
    if (move.axes.has(a)) targets[static_cast<std::size_t>(a)] = move.target[static_cast<std::size_t>(a)];
  return outcome_of(controller_->move(targets));
}

Outcome ProgramHost::arc(const language::Arc& arc) {
  std::optional<std::pair<std::int64_t, std::int64_t>> part;
  if (!arc.full_circle) part = {arc.end_angle, arc.swept_angle};
  return outcome_of(controller_->arc(arc.centre_x, arc.centre_y, arc.clockwise, part));
}

Outcome ProgramHost::home(int axis, language::HomeMode mode, Sign direction) {
  const auto routine = [mode] {
    switch (mode) {
      case language::HomeMode::limit: return HomeMode::limit;
      case language::HomeMode::switch_and_index: return HomeMode::home_index;
      case language::HomeMode::index_only: return HomeMode::index;
      case language::HomeMode::switch_slow: return HomeMode::home_high_low;
      default: return HomeMode::home;
    }
  };
  return outcome_of(controller_->home(axis, routine(), direction));
}

Outcome ProgramHost::jog(int axis, Sign direction) { return outcome_of(controller_->jog(axis, direction)); }

void ProgramHost::stop(language::AxisSet axes) {
  for (int a = 0; a < seen_.axes(); ++a)
    if (axes.empty() || axes.has(a)) controller_->stop(a);
}

void ProgramHost::abort(language::AxisSet axes) {
  for (int a = 0; a < seen_.axes(); ++a)
    if (axes.empty() || axes.has(a)) controller_->abort(a);
}

bool ProgramHost::in_error(int axis) const {
  if (axis >= seen_.axes()) return false;
  const Refusal r = seen_.refuses_motion(1u << axis);
  return r == Refusal::limit_error || r == Refusal::alarm || r == Refusal::loop_error;
}

language::AxisSet ProgramHost::moved_with(int axis) const {
  if (axis >= seen_.axes()) return {};
  return {static_cast<std::uint8_t>(seen_.moved_with(axis))};
}

void ProgramHost::arm_sync(int axis, bool on) {
  if (on)
    controller_->sync_on(axis);
  else
    controller_->sync_off(axis);
}

}  // namespace hw::arcus
