#include "core/devices/arcus/program_places.h"

#include <algorithm>
#include <array>

#include "core/base/index.h"
#include "core/devices/arcus/language/compiler.h"

namespace hw::arcus {
namespace {

using language::Instruction;
using language::Opcode;
using language::Operand;

void add_homed(language::AxisSet& to, const Instruction& next) {
  switch (next.op) {
    case Opcode::home_switch:
    case Opcode::home_limit:
    case Opcode::home_switch_index:
    case Opcode::home_index:
    case Opcode::home_switch_slow:
      for (int axis = 0; axis < language::max_axes; ++axis)
        if (next.axes.has(axis)) to.add(axis);
      break;
    default: break;
  }
}

class PlaceReader {
 public:
  /// Another program of the text begins.
  void begin() { absolute_ = true, counted_ = {}; }
  /// These were homed out of sight.
  void homed(const language::AxisSet& axes) {
    for (int axis = 0; axis < language::max_axes; ++axis)
      if (axes.has(axis)) counted_.add(axis);
  }
  void read(const Instruction& next) {
    add_homed(counted_, next);
    switch (next.op) {
      case Opcode::absolute: absolute_ = true; break;
      case Opcode::incremental: absolute_ = false; break;
      case Opcode::set: set(next.target, next.values[0]); break;
      case Opcode::move:
        for (int axis = 0; absolute_ && axis < language::max_axes; ++axis)
          if (next.axes.has(axis) && !counted_.has(axis))
            places_.push_back(
                {AxisId{static_cast<std::uint8_t>(axis)}, Steps(value_of(next.values[ix(axis)]))});
        break;
      default: break;
    }
  }
  [[nodiscard]] std::vector<AxisTarget> places() && { return std::move(places_); }

 private:
  [[nodiscard]] std::int32_t value_of(const Operand& operand) const {
    if (operand.kind == Operand::Kind::number) return operand.number;
    const bool known = operand.kind == Operand::Kind::variable && operand.number < language::variables;
    return known ? variables_[ix(operand.number)] : 0;
  }
  void set(const Operand& target, const Operand& value) {
    if (target.kind == Operand::Kind::variable && target.number < language::variables)
      variables_[ix(target.number)] = value_of(value);
    const bool counter = target.quantity == language::Quantity::pulse_position ||
                         target.quantity == language::Quantity::encoder_position;
    if (target.kind == Operand::Kind::quantity && counter) counted_.add(target.index);
  }

  bool absolute_ = true;  ///< as after power-up
  language::AxisSet counted_;
  std::array<std::int32_t, language::variables> variables_{};
  std::vector<AxisTarget> places_;
};

}  // namespace

std::vector<AxisTarget> places_of_program(std::string_view text, const language::Dialect& dialect) {
  const language::Program program = language::compile(text, dialect).program;
  const auto begins = [](const auto& heads, std::size_t line) {
    return std::any_of(heads.begin(), heads.end(),
                       [line](const auto& head) { return head && *head == line; });
  };
  language::AxisSet homed_in_subroutines;
  bool in_subroutine = false;
  for (std::size_t line = 0; line < program.code.size(); ++line) {
    in_subroutine = (in_subroutine && !begins(program.programs, line)) || begins(program.subs, line);
    if (in_subroutine) add_homed(homed_in_subroutines, program.code[line]);
  }
  PlaceReader reader;
  for (std::size_t line = 0; line < program.code.size(); ++line) {
    if (begins(program.programs, line)) reader.begin();
    if (program.code[line].op == Opcode::gosub) reader.homed(homed_in_subroutines);
    reader.read(program.code[line]);
  }
  return std::move(reader).places();
}

}  // namespace hw::arcus
