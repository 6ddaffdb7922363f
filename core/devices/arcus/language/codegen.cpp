#include "core/devices/arcus/language/codegen.h"

namespace hw::arcus::language {
namespace {

void append(Generated& out, const Statement& s) {
  auto& code = out.program.code;
  code.push_back(s.instruction);
  Instruction below;
  below.op = shape_of(s.instruction.op) == Shape::link_and_test ? Opcode::test : Opcode::continued;
  for (int n = 1; n < s.instruction.lines; ++n) code.push_back(below);
  out.source_line.insert(out.source_line.end(), s.instruction.lines, s.line);
}

}  // namespace

Generated generate(const std::vector<Statement>& statements) {
  Generated out;
  for (const Statement& s : statements) {
    if (!s.sound) continue;
    out.needed += s.instruction.lines;
    if (out.needed <= program_lines)
      append(out, s);
    else if (!out.first_beyond)
      out.first_beyond = &s;
  }
  // Other errors were reported by check_structure and check_calls.
  (void)link_blocks(out.program.code);
  (void)find_heads(out.program);
  return out;
}

}  // namespace hw::arcus::language
