#pragma once
// Splits a command string into commands as the data sheet writes them: two letters and operands, with or
// without separators. For sending and checking text; the emulated board has its own parser.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/vme58/command_facts.h"

namespace hw::vme58 {

/// Which axes the next command addresses.
struct Context {
  unsigned mode = where::single;  ///< of namespace where, without contour
  int axis = 0;                   ///< in the single mode
  bool recording = false;         ///< between CD and CE or CK
  unsigned contour_axes = 0;      ///< of the latest CD, bit per axis

  [[nodiscard]] unsigned modes() const { return recording ? where::contour : mode; }
  /// The command that selects this context: "AX", "AA", "AM".
  [[nodiscard]] std::string selector() const;
  bool operator==(const Context&) const = default;
};

struct TextCommand {
  std::size_t begin = 0, length = 0;           ///< in the text
  std::string_view text;                       ///< as typed, without trailing separators
  const CommandFact* fact = nullptr;           ///< null: no such command
  Context context;                             ///< in which the board reads the command
  std::vector<std::optional<double>> numbers;  ///< by axis in a list, else by order
  std::string flaw;  ///< why the board would reject the command; empty: no reason known
  std::size_t flaw_begin = 0, flaw_length = 0;  ///< in the text

  [[nodiscard]] bool is(Op op) const { return fact && fact->op == op; }
  [[nodiscard]] std::size_t given() const;
};

/// All commands of `text`, in order. `context` is the context at its start and becomes that at its end.
std::vector<TextCommand> read_commands(std::string_view text, Context& context);
/// `text` with comments (# to the end of the line) and tabs replaced by blanks: the board knows neither.
std::string without_comments(std::string_view text);
/// Whether `op` starts a motion, at once or when its turn comes in the queue.
bool begins_motion(Op op);
/// Whether the command selects the axes of the following ones: AX to AS, AA, AM.
bool selects(const TextCommand& command);
/// Updates `context` for the commands that follow.
void follow(const TextCommand& command, Context& context);

}  // namespace hw::vme58
