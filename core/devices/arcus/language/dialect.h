#pragma once
// The differences between the standalone languages of the two models, as data (chapter 10 of each manual).
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

enum class Indexing : std::uint8_t {
  none,    ///< the name alone, which means index `first` (DMX: PS is the speed of axis 0)
  axis,    ///< an axis letter behind the name
  number,  ///< a number `first` to `last` behind the name
};
enum class Writable : std::uint8_t { no, number, number_or_variable };

/// One name for a quantity.
struct NameRow {
  std::string_view spelling;
  Quantity quantity;
  Indexing indexing = Indexing::none;
  std::uint8_t first = 0, last = 0;
  bool readable = true;
  Writable writable = Writable::no;
  std::int32_t minimum = 0, maximum = 0;  ///< of values that are written
  bool also_zero = false;                 ///< 0 is allowed too
  bool any_is_on = false;                 ///< a number beyond the range means on (AMB-094)
  std::string_view usual{};               ///< not empty: accepted with a warning to write this (AMB-107, 108)

  [[nodiscard]] bool accepts(std::int64_t value) const {
    return (value >= minimum && value <= maximum) || (also_zero && value == 0);
  }
};

/// A statement that is a word with an axis: HOME, JOG, STOP ...
struct WordRow {
  std::string_view spelling;
  Opcode op;
  bool alone = false;  ///< also without a letter: on a controller with several axes, all of them
};

struct Dialect {
  std::string_view model;       ///< as in an address
  std::string_view model_name;  ///< for sentences
  std::string_view axes;        ///< letters
  int programs;
  bool arcs;
  std::span<const NameRow> names;
  std::span<const WordRow> words;
  std::int32_t min_position, max_position;  ///< of a target

  [[nodiscard]] int axis_of(char letter) const {  // -1: no such axis
    const auto at = axes.find(letter);
    return at == std::string_view::npos ? -1 : static_cast<int>(at);
  }
  [[nodiscard]] AxisSet all_axes() const { return {static_cast<std::uint8_t>((1 << axes.size()) - 1)}; }
};

[[nodiscard]] const Dialect& pmx_4ex_sa();
[[nodiscard]] const Dialect& dmx_k_sa();
[[nodiscard]] std::span<const Dialect* const> all_dialects();

/// A name of the dialect found in a text.
struct NameFound {
  const NameRow* row = nullptr;
  int index = 0;  ///< axis or number
};
/// `letters` in capitals; `number`: the digits behind them, or -1.
[[nodiscard]] std::optional<NameFound> find_name(const Dialect& dialect, std::string_view letters,
                                                 int number);

struct WordFound {
  Opcode op = Opcode::bad;
  AxisSet axes;
};
/// "HOMEX", "STOP".
[[nodiscard]] std::optional<WordFound> find_word(const Dialect& dialect, std::string_view letters);

/// The row by which a program writes the quantity; null: it may not.
[[nodiscard]] const NameRow* writable_row(const Dialect& dialect, Quantity quantity);
/// Whether a program may write `value` into the quantity; where any number means on, all fit.
[[nodiscard]] bool can_hold(const Dialect& dialect, Quantity quantity, std::int64_t value);

/// How the maker writes it: "HSPDX", "DI3", "PS"; "V7", "-100".
[[nodiscard]] std::string spell(const Dialect& dialect, Quantity quantity, int index);
[[nodiscard]] std::string spell(const Dialect& dialect, const Operand& operand);

}  // namespace hw::arcus::language
