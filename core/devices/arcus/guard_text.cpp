#include "core/devices/arcus/guard_text.h"

#include <fmt/core.h>

#include "core/devices/arcus/language/compiler.h"

namespace hw::arcus {

std::string guard_text(const Model& model, std::int64_t time_out) {
  constexpr int held = guard_axes_variable, work = guard_work_variable;
  const std::int64_t silent = std::int64_t{1} << model.status.timed_out;
  std::string text = fmt::format("PRG {}\nWHILE V{}>0\nV{}=MSTX&{}\nIF V{}={}\n", guard_program(model), held,
                                 work, silent, work, silent);
  for (int axis = 0; axis < model.axes(); ++axis)
    text += fmt::format("V{0}=V{1}&{2}\nIF V{0}={2}\nSTOP{3}\nENDIF\n", work, held, 1 << axis,
                        model.axis_letters[static_cast<std::size_t>(axis)]);
  return text + fmt::format("V{}=0\nENDIF\nENDWHILE\nTOC={}\nEND\n", held, time_out);
}

std::vector<std::string> guard_lines(const language::Dialect& dialect, const Model& model,
                                     std::int64_t time_out) {
  return language::compile(guard_text(model, time_out), dialect).lines;
}

std::optional<std::int64_t> read_guard(const std::vector<std::string>& lines,
                                       const language::Dialect& dialect, const Model& model) {
  const language::Program code = language::decode(lines, dialect);
  for (const language::Instruction& i : code.code) {
    const bool sets = i.op == language::Opcode::set && i.target.kind == language::Operand::Kind::quantity;
    if (!sets || i.target.quantity != language::Quantity::comm_timeout) continue;
    const std::int64_t time_out = i.values[0].number;
    if (lines == guard_lines(dialect, model, time_out)) return time_out;
  }
  return std::nullopt;
}

JogGuardFacts guard_facts(const Model& model) {
  return {
      "The controller itself stops a jog that you hold when it has received nothing for half a second or a "
      "little longer. This also works when the cable is pulled or the computer is off. It never stops moves, "
      "programs or jogs of scripts.",
      fmt::format("It is written to flash as program {} of the controller and compared, and only if the "
                  "program memory is empty. A program that you download replaces it. While you hold a jog, "
                  "it uses TOC, V{} and V{}; afterwards TOC is restored.",
                  guard_program(model), guard_work_variable, guard_axes_variable),
      "The manual does not say how the time-out is reset: the way used here is a guess until real hardware "
      "confirms it (decision AMB-044). The console's own watchdog stays on as well."};
}

}  // namespace hw::arcus
