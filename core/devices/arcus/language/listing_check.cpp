#include "core/devices/arcus/language/listing_check.h"

#include <string>

#include "core/devices/arcus/language/complaints.h"
#include "core/devices/arcus/language/structure.h"

namespace hw::arcus::language {
namespace {

std::string wrong_setting(const Instruction& i, const Dialect& dialect) {
  const NameRow* row =
      i.target.kind == Operand::Kind::quantity ? writable_row(dialect, i.target.quantity) : nullptr;
  if (!row) return {};
  const Operand& value = i.values[0];
  const std::string name = spell(dialect, i.target);
  if (value.kind == Operand::Kind::variable)
    return row->writable == Writable::number ? name + " takes only a number." : std::string();
  return row->any_is_on || row->accepts(value.number) ? std::string() : value_range(*row, name);
}

std::string wrong_position(const Instruction& i, const Dialect& dialect) {
  for (const Operand& to : i.values)
    if (to.kind == Operand::Kind::number &&
        (to.number < dialect.min_position || to.number > dialect.max_position))
      return position_range(dialect);
  return {};
}

/// The error in the statement's values; empty: none.
std::string wrong_value(const Instruction& i, const Dialect& dialect) {
  switch (shape_of(i.op)) {
    case Shape::target_and_value: return wrong_setting(i, dialect);
    case Shape::axis_targets: return wrong_position(i, dialect);
    case Shape::arc:
      return i.values[3].number > 0 ? std::string()
                                    : "The swept angle must be more than 0, in thousandths of a degree.";
    default: return {};
  }
}

}  // namespace

void check_listing(const Program& program, const std::vector<int>& source_line, const Dialect& dialect,
                   std::vector<Problem>& problems) {
  const std::size_t before = problems.size();
  std::vector<Statement> statements;
  for (std::size_t n = 0; n < program.code.size(); n += program.code[n].lines) {
    const Instruction& i = program.code[n];
    if (i.op == Opcode::empty) continue;
    statements.push_back({i, source_line[n]});
    if (std::string wrong = wrong_value(i, dialect); !wrong.empty()) {
      Problem& problem = problems.emplace_back();
      problem.line = source_line[n];
      problem.sentence = std::move(wrong);
    }
  }
  // Not checked around a missing or invalid line, where the structure need not fit.
  if (before > 0) return;
  check_structure(statements, problems);
  check_calls(statements, problems);
  for (Problem& p : problems)
    p.fix_label.clear(), p.fix_text.clear();  // they would mend a text, not numbered lines
}

}  // namespace hw::arcus::language
