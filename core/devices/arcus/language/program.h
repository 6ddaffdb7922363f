#pragma once
// A stored program: made by the compiler, transferred as lines of text, run by the interpreter. `encode` and
// `decode` convert between a Program and its low-level lines (LISTING.md).
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/units.h"
#include "core/devices/arcus/facts.h"

namespace hw::arcus::language {

inline constexpr int max_line_length = 56;  ///< so that `SA1274=` and the line fit a 64-byte transfer
inline constexpr int max_programs = 4;
inline constexpr int max_axes = most_axes;
inline constexpr int max_call_depth = 8;  ///< GOSUB within GOSUB (AMB-129)
using arcus::error_subroutine, arcus::first_stored_variable, arcus::subroutines, arcus::variables;

struct Dialect;

enum class Opcode : std::uint8_t {
  empty,      ///< an unused line
  continued,  ///< a `+` line of the statement above
  test,       ///< the `+TEST` line of IF, ELSEIF or WHILE as the target of a jump
  bad,        ///< an invalid line; a thread that reaches it is in error
#define OPCODE(name, mnemonic, operands, lines) name,
#include "core/devices/arcus/language/opcodes.def"
#undef OPCODE
};

/// The operand after a mnemonic in a low-level line.
enum class Shape : std::uint8_t {
  nothing,
  number,
  two_numbers,
  link,           ///< a line number
  link_and_test,  ///< a line number; then `+TEST,a,cmp,b,line-if-false`
  target_and_value,
  value_and_result,  ///< a value; then `+PUT,v`, `+NOT,v` or `+ADD,b,v` and its like
  axis,
  axes,  ///< an axis, or nothing for all
  axis_and_sign,
  axis_targets,  ///< an axis and a value; then one `+MOVE` line for each further axis
  centre,        ///< then `+X,n` and `+Y,n`
  arc,           ///< then `+X,n`, `+Y,n`, `+TO,end-angle,swept-angle`
};
[[nodiscard]] Shape shape_of(Opcode op);
[[nodiscard]] std::string_view mnemonic_of(Opcode op);
/// Low-level lines of a statement; 0: one for each of its axes.
[[nodiscard]] int lines_of(Opcode op);

enum class Quantity : std::uint8_t {
#define QUANTITY(name, index) name,
#include "core/devices/arcus/language/quantities.def"
#undef QUANTITY
};

[[nodiscard]] bool has_axis(Quantity quantity);  ///< its index is an axis

/// A source or destination of a value.
struct Operand {
  enum class Kind : std::uint8_t { number, variable, quantity };
  Kind kind = Kind::number;
  Quantity quantity{};
  std::uint8_t index = 0;   ///< axis (0 = X) or the maker's number (DI1: 1); 0 without one
  std::int32_t number = 0;  ///< the number, or the number of the variable

  bool operator==(const Operand&) const = default;
};
constexpr Operand number_operand(std::int32_t n) { return {Operand::Kind::number, {}, 0, n}; }
constexpr Operand variable_operand(int n) { return {Operand::Kind::variable, {}, 0, n}; }
constexpr Operand quantity_operand(Quantity q, int index = 0) {
  return {Operand::Kind::quantity, q, static_cast<std::uint8_t>(index), 0};
}

enum class Comparison : std::uint8_t { equal, greater, less, greater_or_equal, less_or_equal, not_equal };
/// The last two operators, copy and complement, have one operand.
enum class Operator : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  remainder,
  shift_right,
  shift_left,
  bit_and,
  bit_or,
  copy,
  complement,
};

/// Some of the axes X, Y, Z, U.
struct AxisSet {
  std::uint8_t bits = 0;
  [[nodiscard]] constexpr bool has(int axis) const { return bits >> axis & 1; }
  [[nodiscard]] constexpr bool empty() const { return bits == 0; }
  [[nodiscard]] constexpr int count() const { return std::popcount(bits); }
  [[nodiscard]] constexpr int first() const { return std::countr_zero(bits); }
  constexpr void add(int axis) { bits = static_cast<std::uint8_t>(bits | 1 << axis); }
  bool operator==(const AxisSet&) const = default;
};
constexpr AxisSet one_axis(int axis) { return {static_cast<std::uint8_t>(1 << axis)}; }

/// One statement. Which members count depends on `op`; the others keep their defaults.
struct Instruction {
  Opcode op = Opcode::empty;
  std::uint8_t lines = 1;  ///< low-level lines, its `+` lines included
  Comparison comparison = Comparison::equal;
  Operator operation = Operator::copy;
  Sign sign = Sign::plus;
  AxisSet axes;
  std::uint16_t link = 0;      ///< end of the block; for ENDWHILE its WHILE
  std::uint16_t if_false = 0;  ///< where a failed test continues
  Operand target;
  /// number(s): PRG, SUB, GOSUB, DELAY, SR. Tests and READ: a, b. SET: a. MOVE: by axis. Arcs: centre X,
  /// centre Y, end angle, swept angle (thousandths of a degree).
  std::array<Operand, 4> values;

  bool operator==(const Instruction&) const = default;
};

/// An invalid line of a stored program, or one in an invalid place.
struct BadLine {
  int line = 0;
  std::string why;
};

struct Program {
  /// By line. The line where a statement begins holds it; its `+` lines are `continued` (or `test`).
  std::vector<Instruction> code;
  std::array<std::optional<std::uint16_t>, max_programs> programs;  ///< line where PRG n begins
  std::array<std::optional<std::uint16_t>, subroutines> subs;       ///< line of SUB n
  std::vector<BadLine> bad_lines;
};

/// Sets `link` and `if_false` of every block from the places of its lines. Returns the lines that belong to
/// no complete block.
[[nodiscard]] std::vector<int> link_blocks(std::vector<Instruction>& code);

/// Finds the heads of programs and subroutines. Returns the lines that repeat a number.
[[nodiscard]] std::vector<int> find_heads(Program& program);

/// Reads low-level lines. Never fails: an invalid line becomes a bad line. Trailing empty lines are dropped.
[[nodiscard]] Program decode(const std::vector<std::string>& lines, const Dialect& dialect);

/// The low-level lines of one statement, as many as its `lines`.
[[nodiscard]] std::vector<std::string> encode(const Instruction& statement, const Dialect& dialect);
[[nodiscard]] std::vector<std::string> encode(const Program& program, const Dialect& dialect);

}  // namespace hw::arcus::language
