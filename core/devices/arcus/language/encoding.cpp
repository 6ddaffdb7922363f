// Low-level lines from statements. LISTING.md has the grammar; decoding.cpp reads it.
#include "core/devices/arcus/language/encoding.h"

#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {
namespace {

/// Fields joined by commas.
template <class... Fields>
std::string line_of(std::string_view mnemonic, const Fields&... fields) {
  std::string line(mnemonic);
  ((line += ',', line += fields), ...);
  return line;
}

}  // namespace

std::vector<std::string> encode(const Instruction& i, const Dialect& dialect) {
  const std::string_view name = mnemonic_of(i.op);
  const auto value = [&](int n) { return spell(dialect, i.values[n]); };
  const auto axis = [&](int n) { return std::string(1, dialect.axes[n]); };
  switch (shape_of(i.op)) {
    case Shape::nothing: return {std::string(name)};
    case Shape::number: return {line_of(name, value(0))};
    case Shape::two_numbers: return {line_of(name, value(0), value(1))};
    case Shape::link: return {line_of(name, std::to_string(i.link))};
    case Shape::link_and_test:
      return {line_of(name, std::to_string(i.link)), line_of("+TEST", value(0), comparison_code(i.comparison),
                                                             value(1), std::to_string(i.if_false))};
    case Shape::target_and_value: return {line_of(name, spell(dialect, i.target), value(0))};
    case Shape::value_and_result: {
      const std::string code = "+" + std::string(operator_code(i.operation));
      const std::string target = spell(dialect, i.target);
      return {line_of(name, value(0)),
              has_two_operands(i.operation) ? line_of(code, value(1), target) : line_of(code, target)};
    }
    case Shape::axis: return {line_of(name, axis(i.axes.first()))};
    case Shape::axes:
      return {i.axes == dialect.all_axes() && i.axes.count() > 1 ? std::string(name)
                                                                 : line_of(name, axis(i.axes.first()))};
    case Shape::axis_and_sign: return {line_of(name, axis(i.axes.first()), std::string(1, letter(i.sign)))};
    case Shape::axis_targets: {
      std::vector<std::string> lines;
      for (int n = 0; n < max_axes; ++n)
        if (i.axes.has(n)) lines.push_back(line_of(lines.empty() ? "MOVE" : "+MOVE", axis(n), value(n)));
      return lines;
    }
    case Shape::centre: return {std::string(name), line_of("+X", value(0)), line_of("+Y", value(1))};
    case Shape::arc:
      return {std::string(name), line_of("+X", value(0)), line_of("+Y", value(1)),
              line_of("+TO", value(2), value(3))};
  }
  return {};
}

std::vector<std::string> encode(const Program& program, const Dialect& dialect) {
  std::vector<std::string> lines;
  lines.reserve(program.code.size());
  for (const Instruction& i : program.code) {
    if (i.op == Opcode::continued || i.op == Opcode::test) continue;
    for (std::string& line : encode(i, dialect)) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace hw::arcus::language
