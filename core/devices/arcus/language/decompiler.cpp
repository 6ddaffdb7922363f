#include "core/devices/arcus/language/decompiler.h"

#include <algorithm>

#include "core/devices/arcus/language/encoding.h"
#include "core/devices/arcus/language/text_lines.h"

namespace hw::arcus::language {
namespace {

std::string moves_of(const Instruction& i, const Dialect& dialect) {
  std::string text;
  for (int axis = 0; axis < max_axes; ++axis)
    if (i.axes.has(axis))
      text += dialect.axes[static_cast<std::size_t>(axis)] + spell(dialect, i.values[axis]);
  return text;
}

bool ends_section(Opcode op) { return op == Opcode::end || op == Opcode::endsub; }
bool closes_block(Opcode op) {
  return op == Opcode::endif || op == Opcode::endwhile || op == Opcode::else_ || op == Opcode::elseif;
}
bool opens_block(Opcode op) {
  return op == Opcode::if_ || op == Opcode::while_ || op == Opcode::else_ || op == Opcode::elseif;
}

class Writer {
 public:
  Writer(const std::vector<std::string>& lines, const Dialect& dialect)
      : lines_(lines), dialect_(dialect), program_(decode(lines, dialect)) {}

  Decompiled run() {
    for (std::size_t line = 0; line < program_.code.size();) line += write(line);
    out_.bad_lines = std::move(program_.bad_lines);
    return std::move(out_);
  }

 private:
  std::size_t write(std::size_t line) {
    const Instruction& i = program_.code[line];
    if (i.op == Opcode::bad || i.op == Opcode::empty) {
      put(lines_[line].empty() ? ";? (unused)" : ";? " + printable(lines_[line]), 1);
      return 1;
    }
    if (i.op == Opcode::prg || i.op == Opcode::sub || ends_section(i.op)) depth_ = 0;
    if ((i.op == Opcode::prg || i.op == Opcode::sub) && line > 0) break_line();
    if (closes_block(i.op)) depth_ = std::max(depth_ - 1, 0);
    put(source_of(i, dialect_), i.lines);
    if (opens_block(i.op)) ++depth_;
    return i.lines;
  }
  void put(const std::string& text, int low_level_lines) {
    out_.text.append(static_cast<std::size_t>(2 * std::min(depth_, 20)), ' ');
    out_.text += text;
    out_.source_line.insert(out_.source_line.end(), static_cast<std::size_t>(low_level_lines), row_);
    break_line();
  }
  void break_line() {
    out_.text += '\n';
    ++row_;
  }
  /// A line that is no program may contain anything.
  static std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
    return text;
  }

  const std::vector<std::string>& lines_;
  const Dialect& dialect_;
  Program program_;
  Decompiled out_;
  int row_ = 0, depth_ = 0;
};

}  // namespace

Decompiled decompile(const std::vector<std::string>& lines, const Dialect& dialect) {
  return Writer(lines, dialect).run();
}

std::string program_alone(const std::vector<std::string>& lines, const Dialect& dialect, int number) {
  const Program program = decode(lines, dialect);
  const auto head = program.programs[static_cast<std::size_t>(number)];
  if (!head) return {};
  const auto heads_section = [](const Instruction& i) { return i.op == Opcode::prg || i.op == Opcode::sub; };
  const auto begin = program.code.begin() + *head;
  const auto end = std::find_if(begin + 1, program.code.end(), heads_section);
  const Decompiled whole = decompile(lines, dialect);
  const int first = whole.source_line[*head];
  const int last = whole.source_line[static_cast<std::size_t>(end - program.code.begin()) - 1];
  std::string text;
  for_each_line(whole.text, [&](std::string_view line, int row) {
    if (row >= first && row <= last) text.append(line) += '\n';
  });
  return text;
}

std::string source_of(const Instruction& i, const Dialect& dialect) {
  std::string name(mnemonic_of(i.op));
  const auto value = [&](std::size_t n) { return spell(dialect, i.values[n]); };
  const auto axis = [&] { return std::string(1, dialect.axes[static_cast<std::size_t>(i.axes.first())]); };
  switch (shape_of(i.op)) {
    case Shape::nothing:
    case Shape::link: return name;
    case Shape::number: return i.op == Opcode::delay ? name + "=" + value(0) : name + " " + value(0);
    case Shape::two_numbers: return name + value(0) + "=" + value(1);
    case Shape::link_and_test:
      return name + " " + value(0) + std::string(comparison_symbol(i.comparison)) + value(1);
    case Shape::target_and_value: return spell(dialect, i.target) + "=" + value(0);
    case Shape::value_and_result: {
      const std::string target = spell(dialect, i.target) + "=", sign(operator_symbol(i.operation));
      return has_two_operands(i.operation) ? target + value(0) + sign + value(1) : target + sign + value(0);
    }
    case Shape::axis: return name + axis();
    case Shape::axes: return i.axes.count() > 1 ? name : name + axis();
    case Shape::axis_and_sign: return name + axis() + letter(i.sign);
    case Shape::axis_targets: return moves_of(i, dialect);
    case Shape::centre: return name + value(0) + ":" + value(1);
    case Shape::arc: return name + value(0) + ":" + value(1) + ":" + value(2) + ":" + value(3);
  }
  return name;
}

}  // namespace hw::arcus::language
