// Statements from low-level lines. LISTING.md has the grammar; encoding.cpp writes it.
#include <algorithm>
#include <limits>
#include <span>

#include "core/base/number_text.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/encoding.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {
namespace {

using Text = std::string_view;

/// The comma-separated fields of one line.
struct Fields {
  std::array<Text, 5> at;
  int count = 0;  ///< 6: too many

  explicit Fields(Text line) {
    if (line.size() > max_line_length) return;
    for (;;) {
      const auto comma = line.find(',');
      if (count == static_cast<int>(at.size())) {
        ++count;
        return;
      }
      at[static_cast<std::size_t>(count++)] = line.substr(0, comma);
      if (comma == Text::npos) return;
      line.remove_prefix(comma + 1);
    }
  }
  [[nodiscard]] bool is(Text name, int fields) const { return count == fields && at[0] == name; }
};

Opcode opcode_of(Text mnemonic) {
  constexpr auto first = static_cast<int>(Opcode::bad) + 1, last = static_cast<int>(Opcode::store);
  for (int op = first; op <= last; ++op)
    if (mnemonic_of(static_cast<Opcode>(op)) == mnemonic) return static_cast<Opcode>(op);
  return Opcode::bad;
}

/// A number spelt as the encoder writes it: no leading zeros, no +. So each line has only one spelling.
std::optional<std::int32_t> canonical_number(Text text) {
  const auto n = whole_number<std::int32_t>(text);
  return n && std::to_string(*n) == text ? n : std::nullopt;
}

/// Reads one statement from its lines. Every `read_...` returns whether the expected part was there.
class StatementReader {
 public:
  StatementReader(std::span<const std::string> lines, const Dialect& dialect)
      : lines_(lines), dialect_(dialect) {}

  /// Op `bad` if the lines are invalid; then `lines` is 1.
  Instruction read() {
    const Fields head(lines_.front());
    i_.op = opcode_of(head.at[0]);
    if (i_.op == Opcode::bad || !read_statement(head)) {
      i_ = {};
      i_.op = Opcode::bad;
    }
    return i_;
  }

 private:
  bool read_statement(const Fields& head) {
    switch (shape_of(i_.op)) {
      case Shape::nothing: return head.count == 1;
      case Shape::number: return head.count == 2 && read_number(head.at[1], 0) && number_fits();
      case Shape::two_numbers:
        return head.count == 3 && read_number(head.at[1], 0) && read_number(head.at[2], 1) && number_fits();
      case Shape::link: return head.count == 2 && read_line(head.at[1], i_.link);
      case Shape::link_and_test: return head.count == 2 && read_line(head.at[1], i_.link) && read_test();
      case Shape::target_and_value:
        return head.count == 3 && read_target(head.at[1]) && read_plain(head.at[2], 0);
      case Shape::value_and_result: return head.count == 2 && read_value(head.at[1], 0) && read_result();
      case Shape::axis: return head.count == 2 && read_axis(head.at[1]);
      case Shape::axes: return read_axes(head);
      case Shape::axis_and_sign: return head.count == 3 && read_axis(head.at[1]) && read_sign(head.at[2]);
      case Shape::axis_targets: return read_targets(head);
      case Shape::centre: return dialect_.arcs && head.count == 1 && read_part("+X", 0) && read_part("+Y", 1);
      case Shape::arc:
        return dialect_.arcs && head.count == 1 && read_part("+X", 0) && read_part("+Y", 1) && read_angles();
    }
    return false;
  }

  /// The next `+` line of the statement.
  std::optional<Fields> next() {
    if (i_.lines >= lines_.size()) return std::nullopt;
    return Fields(lines_[i_.lines++]);
  }

  bool read_number(Text text, std::size_t at) {
    const auto n = canonical_number(text);
    if (n) i_.values[at] = number_operand(*n);
    return n.has_value();
  }
  [[nodiscard]] bool number_fits() const {
    const int n = i_.values[0].number;
    switch (i_.op) {
      case Opcode::prg: return n >= 0 && n < dialect_.programs;
      case Opcode::run:
        return n >= 0 && n < dialect_.programs && i_.values[1].number >= 0 && i_.values[1].number <= 3;
      case Opcode::delay: return n > 0;
      default: return n >= 0 && n < subroutines;
    }
  }
  static bool read_line(Text text, std::uint16_t& line) {
    const auto n = canonical_number(text);
    if (!n || *n < 0 || *n >= program_lines) return false;
    line = static_cast<std::uint16_t>(*n);
    return true;
  }

  /// A number, a variable or a name.
  [[nodiscard]] std::optional<Operand> operand(Text text, const NameRow** row = nullptr) const {
    if (const auto n = canonical_number(text)) return number_operand(*n);
    const auto digits = std::find_if(text.begin(), text.end(), is_digit);
    const Text letters = text.substr(0, static_cast<std::size_t>(digits - text.begin()));
    int n = -1;
    if (digits != text.end()) {
      const auto number = canonical_number(text.substr(letters.size()));
      if (!number || *number > 999) return std::nullopt;
      n = *number;
    }
    if (letters == "V") {
      if (n < 0 || n >= variables) return std::nullopt;
      return variable_operand(n);
    }
    const auto found = find_name(dialect_, letters, n);
    if (!found || !found->row->usual.empty()) return std::nullopt;
    if (found->row->indexing == Indexing::number && (n < found->row->first || n > found->row->last))
      return std::nullopt;
    if (row) *row = found->row;
    return quantity_operand(found->row->quantity, found->index);
  }
  bool read_value(Text text, std::size_t at) {
    const NameRow* row = nullptr;
    const auto value = operand(text, &row);
    if (!value || (row && !row->readable)) return false;
    i_.values[at] = *value;
    return true;
  }
  /// A number or a variable.
  bool read_plain(Text text, std::size_t at) {
    return read_value(text, at) && i_.values[at].kind != Operand::Kind::quantity;
  }
  bool read_target(Text text) {
    const NameRow* row = nullptr;
    const auto target = operand(text, &row);
    if (!target || target->kind == Operand::Kind::number || (row && row->writable == Writable::no))
      return false;
    i_.target = *target;
    return true;
  }
  bool read_result() {
    const auto line = next();
    if (!line || line->at[0].empty() || line->at[0].front() != '+') return false;
    const auto operation = operator_from_code(line->at[0].substr(1));
    if (!operation) return false;
    i_.operation = *operation;
    const bool two = has_two_operands(*operation);
    if (line->count != (two ? 3 : 2) || (two && !read_value(line->at[1], 1))) return false;
    return read_target(line->at[two ? 2 : 1]) && i_.target.kind == Operand::Kind::variable;
  }
  bool read_test() {
    const auto line = next();
    if (!line || !line->is("+TEST", 5)) return false;
    const auto comparison = comparison_from_code(line->at[2]);
    if (!comparison) return false;
    i_.comparison = *comparison;
    return read_value(line->at[1], 0) && read_value(line->at[3], 1) && read_line(line->at[4], i_.if_false);
  }

  bool read_axis(Text text) {
    const int axis = text.size() == 1 ? dialect_.axis_of(text.front()) : -1;
    if (axis < 0) return false;
    i_.axes.add(axis);
    return true;
  }
  bool read_axes(const Fields& head) {
    if (head.count == 2) return read_axis(head.at[1]);
    i_.axes = dialect_.all_axes();
    return head.count == 1 && i_.axes.count() > 1;
  }
  bool read_sign(Text text) {
    i_.sign = text == "+" ? Sign::plus : Sign::minus;
    return text == "+" || text == "-";
  }
  bool read_targets(const Fields& head) {
    const auto read_one = [&](const Fields& line) {
      const int axis = line.at[1].size() == 1 ? dialect_.axis_of(line.at[1].front()) : -1;
      if (line.count != 3 || axis < 0 || i_.axes.bits >> axis) return false;  // in the order of the axes
      i_.axes.add(axis);
      return read_plain(line.at[2], static_cast<std::size_t>(axis));
    };
    if (!read_one(head)) return false;
    while (i_.lines < lines_.size() && lines_[i_.lines].starts_with("+MOVE,"))
      if (!read_one(*next())) return false;
    return true;
  }
  bool read_part(Text name, std::size_t at) {
    const auto line = next();
    return line && line->is(name, 2) && read_number(line->at[1], at);
  }
  bool read_angles() {
    const auto line = next();
    return line && line->is("+TO", 3) && read_number(line->at[1], 2) && read_number(line->at[2], 3);
  }

  std::span<const std::string> lines_;
  const Dialect& dialect_;
  Instruction i_;
};

void mark_bad(Program& program, int line, std::string why) {
  Instruction& i = program.code[static_cast<std::size_t>(line)];
  const auto lines = i.lines;
  for (int n = 0; n < lines; ++n) {
    program.code[static_cast<std::size_t>(line + n)] = {};
    program.code[static_cast<std::size_t>(line + n)].op = Opcode::bad;
  }
  program.bad_lines.push_back({line, std::move(why)});
}

/// Checks that the lines of each block name its ends: otherwise the block would run differently from how it
/// reads.
void check_blocks(Program& program) {
  const std::vector<Instruction> as_loaded = program.code;
  for (const int line : link_blocks(program.code)) mark_bad(program, line, "belongs to no complete block");
  for (std::size_t line = 0; line < program.code.size(); ++line) {
    const Instruction& i = program.code[line];
    if (i.link != as_loaded[line].link || i.if_false != as_loaded[line].if_false)
      if (i.op != Opcode::bad)
        mark_bad(program, static_cast<int>(line), "names other lines than its block has");
  }
}

}  // namespace

Program decode(const std::vector<std::string>& lines, const Dialect& dialect) {
  Program program;
  std::span<const std::string> rest(lines);
  while (!rest.empty() && rest.back().empty()) rest = rest.first(rest.size() - 1);
  if (rest.size() > program_lines) rest = rest.first(program_lines);
  program.code.reserve(rest.size());
  while (!rest.empty()) {
    Instruction i;
    if (!rest.front().empty()) i = StatementReader(rest, dialect).read();
    if (i.op == Opcode::bad)
      program.bad_lines.push_back({static_cast<int>(program.code.size()), "means nothing"});
    program.code.push_back(i);
    for (int n = 1; n < i.lines; ++n) {
      Instruction below;
      below.op = shape_of(i.op) == Shape::link_and_test ? Opcode::test : Opcode::continued;
      program.code.push_back(below);
    }
    rest = rest.subspan(i.lines);
  }
  check_blocks(program);
  for (const int line : find_heads(program)) mark_bad(program, line, "repeats a number that is taken");
  return program;
}

}  // namespace hw::arcus::language
