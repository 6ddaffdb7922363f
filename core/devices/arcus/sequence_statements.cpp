#include "core/devices/arcus/sequence_statements.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/arcus/language/decompiler.h"
#include "core/devices/arcus/language/lexer.h"
#include "core/devices/arcus/language/text_lines.h"

namespace hw::arcus {

using language::Instruction;
using language::Opcode;
using language::Operand;
using language::Quantity;

namespace {

/// False: a line is not understood.
bool read_statements(std::string_view text, const language::Dialect& dialect, Statements& statements) {
  std::vector<Problem> problems;
  language::LexedLine lexed;
  language::LineParser parser(dialect, problems);
  language::for_each_line(text, [&](std::string_view line, int number) {
    lexed.read(line);
    if (auto s = parser.parse(lexed, number)) statements.push_back(*s);
  });
  return std::none_of(problems.begin(), problems.end(), [](const Problem& p) { return p.error; });
}

constexpr int uses_of_a_loop = 4;  // uses of its variable

bool is_variable(const Operand& o, int n) { return o.kind == Operand::Kind::variable && o.number == n; }

bool opens(Opcode op) { return op == Opcode::if_ || op == Opcode::while_; }
bool closes(Opcode op) { return op == Opcode::endif || op == Opcode::endwhile; }

/// The name of a quantity that speed steps set; empty: another quantity.
std::string_view speed_of(const Operand& target) {
  if (target.kind != Operand::Kind::quantity) return {};
  switch (target.quantity) {
    case Quantity::high_speed: return "HSPD";
    case Quantity::low_speed: return "LSPD";
    case Quantity::acceleration: return "ACC";
    default: return {};
  }
}

/// How often the statements use each variable.
std::array<int, language::variables> uses_of(const Statements& statements, std::size_t from, std::size_t to) {
  std::array<int, language::variables> uses{};
  const auto use = [&uses](const Operand& o) {
    if (o.kind == Operand::Kind::variable && o.number >= 0 && ix(o.number) < uses.size())
      ++uses[ix(o.number)];
  };
  for (std::size_t i = from; i < to; ++i) {
    use(statements[i].instruction.target);
    for (const Operand& value : statements[i].instruction.values) use(value);
  }
  return uses;
}

std::optional<CountedLoop> counted_loop(const StatementText& text, std::size_t head) {
  const Instruction& test = text.at(head);
  const std::size_t end = text.end_of[head];
  if (test.op != Opcode::while_ || head == 0 || end < head + 2) return std::nullopt;
  const Instruction &set = text.at(head - 1), &count = text.at(end - 1);
  const int variable = set.target.number;
  const bool counts = set.op == Opcode::set && is_variable(set.target, variable) &&
                      is_number(set.values[0], 0) && is_variable(test.values[0], variable) &&
                      test.comparison == language::Comparison::less &&
                      test.values[1].kind == Operand::Kind::number && test.values[1].number > 0 &&
                      count.op == Opcode::compute && count.operation == language::Operator::add &&
                      is_variable(count.target, variable) && is_variable(count.values[0], variable) &&
                      is_number(count.values[1], 1);
  if (!counts || uses_of(text.statements, head + 1, end - 1)[ix(variable)] > 0) return std::nullopt;
  return CountedLoop{test.values[1].number, variable, head - 1, head, end - 1, end};
}

}  // namespace

StatementText::StatementText(std::string_view text, const language::Dialect& dialect) {
  (void)read_statements(text, dialect, statements);
  language::for_each_line(text, [&](std::string_view line, int) {
    const auto begin = static_cast<std::size_t>(line.data() - text.data());
    lines.push_back({begin, begin + line.size()});
  });
  end_of.resize(statements.size());
  counted.resize(statements.size());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    end_of[i] = i;
    const Opcode op = at(i).op;
    if (opens(op)) open.push_back(i);
    if (closes(op) && !open.empty()) end_of[open.back()] = i, open.pop_back();
  }
  std::vector<CountedLoop> loops;
  std::array<int, language::variables> counting{};
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (const auto loop = counted_loop(*this, i))
      loops.push_back(*loop), counting[ix(loop->variable)] += uses_of_a_loop;
  const auto uses = uses_of(statements, 0, statements.size());
  for (const CountedLoop& loop : loops)
    if (uses[ix(loop.variable)] == counting[ix(loop.variable)])
      for (const std::size_t i : {loop.set, loop.head, loop.count, loop.end}) counted[i] = loop;
}

Stretch StatementText::stretch(std::size_t i) const {
  const Stretch& line = lines[ix(statements[i].line)];
  return {line.begin + ix(statements[i].column), line.end};
}

static bool switches_power_of_several(const Instruction& s, const language::Dialect& dialect) {
  return s.op == Opcode::set && s.target.kind == Operand::Kind::quantity &&
         s.target.quantity == Quantity::enables && is_number(s.values[0]) && dialect.axes.size() > 1;
}
/// EO=3 means the same as EO1=1, EO2=1, EO3=0 and EO4=0.
static void add_power_of_each(const Operation& of_all, const Instruction& s, const language::Dialect& dialect,
                              Operations& operations) {
  Instruction one = s;
  one.target.quantity = Quantity::enable;
  for (std::size_t axis = 0; axis < dialect.axes.size(); ++axis) {
    one.target.index = static_cast<std::uint8_t>(axis + 1);
    one.values[0].number = (s.values[0].number >> axis) & 1;
    operations.push_back(of_all);
    operations.back().text = source_of(one, dialect);
  }
}

Operations operations_of(std::string_view text, const language::Dialect& dialect) {
  const StatementText read(text, dialect);
  Operations operations;
  for (std::size_t i = 0; i < read.statements.size(); ++i) {
    const Instruction& s = read.at(i);
    if (i == 0 && s.op == Opcode::prg && is_number(s.values[0], 0))
      continue;  // the heading may be written or not
    Operation operation;
    operation.text = source_of(s, dialect);
    operation.at = read.stretch(i);
    if (opens(s.op))
      operation.flow = Operation::Flow::begins_block;
    else if (closes(s.op))
      operation.flow = Operation::Flow::ends_block;
    else if (s.op == Opcode::elseif || s.op == Opcode::else_)
      operation.flow = Operation::Flow::next_branch;
    else if (s.op == Opcode::prg || s.op == Opcode::sub || s.op == Opcode::gosub)
      operation.flow = Operation::Flow::changes_all;
    if (s.op == Opcode::absolute || s.op == Opcode::incremental) operation.sets = "mode";
    if (goes_by_mode(s.op)) operation.uses = "mode";
    if (s.op == Opcode::set || s.op == Opcode::compute) {
      operation.sets = speed_of(s.target);
      operation.speed = !operation.sets.empty();
      operation.constant = s.op == Opcode::set && s.values[0].kind == Operand::Kind::number;
    }
    if (const auto& loop = read.counted[i])  // whichever variable counts
      operation.text = i == loop->set     ? "count=0"
                       : i == loop->head  ? fmt::format("WHILE count<{}", loop->times)
                       : i == loop->count ? "count=count+1"
                                          : "ENDWHILE";
    if (switches_power_of_several(s, dialect))
      add_power_of_each(operation, s, dialect, operations);
    else
      operations.push_back(std::move(operation));
  }
  return operations;
}

void add_remarks(const StatementText& text, const language::Compilation& compiled, TextRemarks& remarks) {
  std::vector<Opcode> ops(text.lines.size(), Opcode::empty);
  for (const language::Statement& s : text.statements) ops[ix(s.line)] = s.instruction.op;
  for (std::size_t line = 0; line < std::min(ops.size(), compiled.text.size()); ++line)
    for (const Token& token : compiled.text[line].tokens)
      if (token.kind == TokenKind::comment && ops[line] != Opcode::sub)
        remarks.add({text.lines[line].begin + ix(token.begin), text.lines[line].end},
                    ops[line] != Opcode::empty);
}

bool asks_input(const Instruction& s) {
  return s.values[0].kind == Operand::Kind::quantity && s.values[0].quantity == Quantity::input &&
         s.comparison == language::Comparison::equal &&
         (is_number(s.values[1], 0) || is_number(s.values[1], 1));
}

TextEffects effects_of(std::string_view text, const language::Dialect& dialect) {
  Statements statements;
  if (!read_statements(text, dialect, statements)) return {true, true, true};
  TextEffects all;
  for (const language::Statement& statement : statements) {
    const Instruction& s = statement.instruction;
    if (s.op == Opcode::gosub || s.op == Opcode::prg || s.op == Opcode::sub) return {true, true, true};
    all.mode |= s.op == Opcode::absolute || s.op == Opcode::incremental;
    const bool puts = s.op == Opcode::set || s.op == Opcode::compute;
    all.speeds |= puts && !speed_of(s.target).empty();
    all.moves |=
        (s.op >= Opcode::move && s.op <= Opcode::abort) ||
        (puts && s.target.kind == Operand::Kind::quantity &&
         (s.target.quantity == Quantity::pulse_position || s.target.quantity == Quantity::encoder_position ||
          s.target.quantity == Quantity::loop_enable));
  }
  return all;
}

}  // namespace hw::arcus
