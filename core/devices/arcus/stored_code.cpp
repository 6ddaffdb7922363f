#include "core/devices/arcus/stored_code.h"

#include <initializer_list>

namespace hw::arcus {
namespace {

using language::Instruction;
using language::Opcode;
using language::Quantity;

class SetParams {
 public:
  explicit SetParams(const Model& model) : model_(model) {}
  /// Of one axis where there is one for each of them; `axis` -1: of all.
  void add(Setting id, int axis = -1) {
    std::size_t first = 0;
    for (const SettingFact& fact : model_.settings) {
      const auto count = static_cast<std::size_t>(fact.count);
      for (std::size_t i = 0; fact.id == id && i < count; ++i)
        if (axis < 0 || fact.count == 1 || static_cast<int>(i) == axis) found_.set(first + i);
      first += count;
    }
  }
  /// Times of ramps are adjusted to the speeds.
  void add_speed(Setting id, int axis = -1) {
    add(id, axis);
    for (const Setting time : {Setting::accel, Setting::decel, Setting::axis_accel, Setting::axis_decel})
      add(time);
  }
  void add_all() { found_.set(); }
  void add_written(Quantity quantity, int axis);
  [[nodiscard]] const std::bitset<max_params>& found() const { return found_; }

 private:
  const Model& model_;
  std::bitset<max_params> found_;
};

void SetParams::add_written(Quantity quantity, int axis) {
  switch (quantity) {
    case Quantity::acceleration: return add(Setting::accel);
    case Quantity::deceleration: return add(Setting::decel);
    case Quantity::high_speed: return add_speed(Setting::high_speed);
    case Quantity::low_speed: return add_speed(Setting::low_speed);
    case Quantity::axis_acceleration: return add(Setting::axis_accel, axis);
    case Quantity::axis_deceleration: return add(Setting::axis_decel, axis);
    case Quantity::axis_high_speed: return add_speed(Setting::axis_high_speed, axis);
    case Quantity::axis_low_speed: return add_speed(Setting::axis_low_speed, axis);
    case Quantity::s_curve: return add(Setting::s_curve, axis);
    case Quantity::loop_enable: return add(Setting::loop, axis);
    case Quantity::speed_window: return add(Setting::speed_window, axis);
    case Quantity::comm_timeout: return add(Setting::comm_timeout);
    case Quantity::sync_condition: return add(Setting::sync_condition, axis);
    case Quantity::sync_position: return add(Setting::sync_position, axis);
    case Quantity::sync_time: return add(Setting::sync_width, axis);
    case Quantity::run_current: return add(Setting::run_current);
    case Quantity::idle_current: return add(Setting::idle_current);
    case Quantity::idle_delay: return add(Setting::idle_time);
    case Quantity::pulse_position:
    case Quantity::encoder_position:
    case Quantity::new_speed:
    case Quantity::outputs:
    case Quantity::output:
    case Quantity::enables:
    case Quantity::enable:
    case Quantity::timer:
    case Quantity::latch_enable: return;  // no parameters
    default: return add_all();            // the joystick's, which switch StepNLoop, too
  }
}

}  // namespace

StoredCode read_stored_code(const language::Program& code, const Model& model) {
  StoredCode stored;
  for (std::size_t n = 0; n < stored.programs.size(); ++n)
    stored.programs.set(n, code.programs[n].has_value());
  SetParams params(model);
  for (const Instruction& i : code.code) {
    if (i.op == Opcode::store) params.add_all();
    if (i.op == Opcode::set && i.target.kind == language::Operand::Kind::quantity)
      params.add_written(i.target.quantity, i.target.index);
  }
  stored.sets = params.found();
  return stored;
}

}  // namespace hw::arcus
