#pragma once
// Program texts as statements, for conversion between steps and texts.
#include <optional>
#include <string_view>
#include <vector>

#include "core/device/sequence_reading.h"
#include "core/device/text_remarks.h"
#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/parser.h"

namespace hw::arcus {

using Statements = std::vector<language::Statement>;

inline bool is_number(const language::Operand& o) { return o.kind == language::Operand::Kind::number; }
inline bool is_number(const language::Operand& o, std::int32_t n) { return is_number(o) && o.number == n; }

/// Whether ABS or INC decides the target of the statement.
inline bool goes_by_mode(language::Opcode op) {
  return op >= language::Opcode::move && op <= language::Opcode::circle_counterclockwise;
}

/// "IF DI1=1", "WHILE DI1=0".
bool asks_input(const language::Instruction& s);

/// V1=0, WHILE V1<10, ..., V1=V1+1, ENDWHILE, where nothing else in the text uses that variable.
struct CountedLoop {
  int times = 1, variable = 0;
  std::size_t set = 0, head = 0, count = 0, end = 0;  ///< places of its statements
};

/// A text without mistakes.
struct StatementText {
  Statements statements;
  /// For each statement: for the head of a block (WHILE, IF, ELSEIF, ELSE) the statement that ends the block,
  /// else itself.
  std::vector<std::size_t> end_of;
  std::vector<std::optional<CountedLoop>> counted;  ///< by statement that belongs to a counted loop
  std::vector<Stretch> lines;                       ///< of the text, without their ends

  StatementText(std::string_view text, const language::Dialect& dialect);
  [[nodiscard]] const language::Instruction& at(std::size_t i) const { return statements[i].instruction; }
  /// From its first character to the end of its line, remark included.
  [[nodiscard]] Stretch stretch(std::size_t i) const;
};

/// Adds the text's comments, except the names of the tool's routines. `compiled`: the same text.
void add_remarks(const StatementText& text, const language::Compilation& compiled, TextRemarks& remarks);

[[nodiscard]] Operations operations_of(std::string_view text, const language::Dialect& dialect);

/// The settings that lines within a program may leave changed.
struct TextEffects {
  bool moves = false, speeds = false, mode = false;
};
[[nodiscard]] TextEffects effects_of(std::string_view text, const language::Dialect& dialect);

}  // namespace hw::arcus
