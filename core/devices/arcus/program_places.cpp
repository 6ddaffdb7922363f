#include "core/devices/arcus/program_places.h"

#include <array>
#include <optional>
#include <utility>

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

/// The place of a program, as far as its text gives it.
struct Standing {
  bool absolute = true;       ///< as after power-up
  language::AxisSet counted;  ///< these have been homed, or their count has been set
};

class PlaceReader {
 public:
  explicit PlaceReader(const language::Program& program) : program_(program) {}

  void read_program(int number, Standing standing) {
    const auto& programs = program_.programs;
    if (number < 0 || ix(number) >= programs.size() || !programs[ix(number)]) return;
    if (std::exchange(read_[ix(number)], true)) return;
    const int starter = std::exchange(depth_, 0);  // each thread has a stack of its own
    const auto of_starter = std::exchange(at_error_, std::nullopt);
    read_from(*programs[ix(number)], standing);
    may_fail(standing);
    const auto& on_error = program_.subs[language::error_subroutine];
    if (auto at_error = std::exchange(at_error_, std::nullopt); at_error && on_error)
      read_from(*on_error, *at_error);
    at_error_ = of_starter;
    depth_ = starter;
  }
  [[nodiscard]] std::vector<AxisTarget> places() && { return std::move(places_); }

 private:
  /// Reads from the line of a head to the next head.
  void read_from(std::size_t head, Standing& standing) {
    if (depth_ > language::max_call_depth) return;  // the program itself is no call
    ++depth_;
    for (std::size_t line = head + 1; line < program_.code.size() && left_ > 0; ++line, --left_) {
      const Instruction& next = program_.code[line];
      if (next.op == Opcode::prg || next.op == Opcode::sub) break;
      read(next, standing);
    }
    --depth_;
  }
  void read(const Instruction& next, Standing& standing) {
    may_fail(standing);
    add_homed(standing.counted, next);
    switch (next.op) {
      case Opcode::absolute: standing.absolute = true; break;
      case Opcode::incremental: standing.absolute = false; break;
      case Opcode::set: set(next.target, next.values[0], standing); break;
      case Opcode::gosub: call(next.values[0].number, standing); break;
      case Opcode::run:
        if (next.values[1].number == start_it) read_program(next.values[0].number, standing);
        break;
      case Opcode::move: move(next, standing); break;
      default: break;
    }
  }
  /// The error subroutine may start at any statement, long behind the motion that failed: it can rely only on
  /// facts that hold at each of them.
  void may_fail(const Standing& standing) {
    if (!at_error_) {
      at_error_ = standing;
      return;
    }
    at_error_->absolute = at_error_->absolute || standing.absolute;
    language::AxisSet counted;
    for (int axis = 0; axis < language::max_axes; ++axis)
      if (at_error_->counted.has(axis) && standing.counted.has(axis)) counted.add(axis);
    at_error_->counted = counted;
  }
  void call(std::int32_t sub, Standing& standing) {
    if (sub >= 0 && sub < language::subroutines && program_.subs[ix(sub)])
      read_from(*program_.subs[ix(sub)], standing);
  }
  void move(const Instruction& next, const Standing& standing) {
    for (int axis = 0; standing.absolute && axis < language::max_axes; ++axis)
      if (next.axes.has(axis) && !standing.counted.has(axis))
        places_.push_back({AxisId{static_cast<std::uint8_t>(axis)}, Steps(value_of(next.values[ix(axis)]))});
  }
  void set(const Operand& target, const Operand& value, Standing& standing) {
    if (target.kind == Operand::Kind::variable && target.number < language::variables)
      variables_[ix(target.number)] = value_of(value);
    const bool counter = target.quantity == language::Quantity::pulse_position ||
                         target.quantity == language::Quantity::encoder_position;
    if (target.kind == Operand::Kind::quantity && counter) standing.counted.add(target.index);
  }
  [[nodiscard]] std::int32_t value_of(const Operand& operand) const {
    if (operand.kind == Operand::Kind::number) return operand.number;
    const bool known = operand.kind == Operand::Kind::variable && operand.number < language::variables;
    return known ? variables_[ix(operand.number)] : 0;
  }

  static constexpr std::int32_t start_it = 1;  // of SR

  const language::Program& program_;
  std::array<bool, language::max_programs> read_{};  ///< programs that have been
  std::array<std::int32_t, language::variables> variables_{};
  std::vector<AxisTarget> places_;
  std::optional<Standing> at_error_;  ///< of the program that is being read
  int depth_ = 0, left_ = 100'000;    ///< calls; lines to be read at most
};

}  // namespace

std::vector<AxisTarget> places_of_program(std::string_view text, int start,
                                          const language::Dialect& dialect) {
  const language::Program program = language::compile(text, dialect).program;
  PlaceReader reader(program);
  reader.read_program(start, {});
  return std::move(reader).places();
}

}  // namespace hw::arcus
