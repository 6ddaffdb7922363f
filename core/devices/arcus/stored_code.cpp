#include "core/devices/arcus/stored_code.h"

#include <initializer_list>

namespace hw::arcus {
namespace {

using language::Instruction;
using language::Opcode;
using language::Operand;
using language::Quantity;

class SetParams {
 public:
  explicit SetParams(const Model& model) : model_(model) {}
  /// Adds the setting of one axis, if each axis has its own; `axis` -1: of all axes.
  void add(Setting id, int axis = -1) {
    std::size_t first = 0;
    for (const SettingFact& fact : model_.settings) {
      const auto count = static_cast<std::size_t>(fact.count);
      for (std::size_t i = 0; fact.id == id && i < count; ++i)
        if (axis < 0 || fact.count == 1 || static_cast<int>(i) == axis) found_.set(first + i);
      first += count;
    }
  }
  /// Adds a speed, and the ramp times, which the controller adjusts to the speeds.
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
    default: return add_all();            // also the joystick's, which switch StepNLoop
  }
}

/// The effects of a subroutine from its head to its end, with the subroutines that it calls. Without a loop
/// it has ended after the time for each of its statements.
class SubroutineWalk {
 public:
  explicit SubroutineWalk(const language::Program& code) : code_(code) {}
  StoredSubroutine walk(std::size_t number) {
    go_through(*code_.subs[number], 0);
    const bool returns_in_error =
        code_.subs[language::error_subroutine].has_value();  // to the same statement
    if (!ends_ || (returns_in_error && moves_)) return {moves_, std::nullopt};
    return {moves_, rests_};
  }

 private:
  void go_through(std::size_t line, int depth);
  void count(const Instruction& statement, int depth);
  void give_up() { moves_ = true, ends_ = false; }

  static constexpr Duration between_two =
      Millis(500);  // readings of an axis: a short move may fall in between
  static constexpr Duration of_a_statement = Millis(10);  // ten times the time in AMB-127
  static constexpr int most_statements = 10'000;
  const language::Program& code_;
  Duration rests_ = std::chrono::seconds(1);
  bool moves_ = false, ends_ = true;
  int statements_ = 0;
};

void SubroutineWalk::go_through(std::size_t line, int depth) {
  for (; line < code_.code.size() && statements_ < most_statements; ++line) {
    const Instruction& statement = code_.code[line];
    if (statement.op == Opcode::endsub || statement.op == Opcode::end) return;
    count(statement, depth);
  }
}

void SubroutineWalk::count(const Instruction& statement, int depth) {
  const Operand& first = statement.values[0];
  rests_ += of_a_statement;
  if (++statements_ == most_statements) give_up();
  switch (statement.op) {
    case Opcode::delay: rests_ += Millis(first.number); break;
    case Opcode::while_: ends_ = false; break;
    case Opcode::gosub: {
      const auto n = static_cast<std::size_t>(first.number);
      if (depth >= language::max_call_depth || n >= code_.subs.size())
        give_up();
      else if (code_.subs[n])
        go_through(*code_.subs[n], depth + 1);
      break;
    }
    case Opcode::set: moves_ = moves_ || statement.target == quantity_operand(Quantity::joystick_axes); break;
    case Opcode::run:
    case Opcode::move:
    case Opcode::arc_clockwise:
    case Opcode::arc_counterclockwise:
    case Opcode::circle_clockwise:
    case Opcode::circle_counterclockwise:
    case Opcode::home_switch:
    case Opcode::home_limit:
    case Opcode::home_switch_index:
    case Opcode::home_index:
    case Opcode::home_switch_slow:
    case Opcode::jog:
      moves_ = true;
      rests_ += between_two;
      break;
    default: break;
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
    if (i.op != Opcode::set || i.target.kind != language::Operand::Kind::quantity) continue;
    params.add_written(i.target.quantity, i.target.index);
    const bool motors = i.target.quantity == Quantity::enables || i.target.quantity == Quantity::enable;
    stored.switches_motors = stored.switches_motors || motors;
  }
  stored.sets = params.found();
  for (std::size_t n = 0; n < stored.subs.size(); ++n)
    if (code.subs[n]) stored.subs[n] = SubroutineWalk(code).walk(n);
  return stored;
}

}  // namespace hw::arcus
