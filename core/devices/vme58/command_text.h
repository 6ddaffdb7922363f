#pragma once
// A command string cut into its commands, as the data sheet writes them: two letters and what follows, with
// or without separators. For whoever sends or checks text; the board has a parser of its own.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/vme58/command_facts.h"

namespace hw::vme58 {

/// Which axes the next command speaks to.
struct Context {
  unsigned mode = where::single;  ///< of namespace where, without contour
  int axis = 0;                   ///< in the single mode
  bool recording = false;         ///< between CD and CE or CK
  unsigned contour_axes = 0;      ///< of the latest CD, bit per axis

  [[nodiscard]] unsigned modes() const { return recording ? where::contour : mode; }
  /// The command that selects it: "AX", "AA", "AM".
  [[nodiscard]] std::string selector() const;
  bool operator==(const Context&) const = default;
};

struct TextCommand {
  std::size_t begin = 0, length = 0;           ///< in the text
  std::string_view text;                       ///< as typed, without separators behind it
  const CommandFact* fact = nullptr;           ///< null: no such command
  Context context;                             ///< in which it is read
  std::vector<std::optional<double>> numbers;  ///< by place: the axis of a list, else the order
  std::string flaw;                            ///< why the board will not take it as it stands; empty: it may
  std::size_t flaw_begin = 0, flaw_length = 0;  ///< in the text

  [[nodiscard]] bool is(Op op) const { return fact && fact->op == op; }
  [[nodiscard]] std::size_t given() const;
};

/// All commands of `text`, in their order; `context` is that of its begin and becomes that of its end.
std::vector<TextCommand> read_commands(std::string_view text, Context& context);
/// The text with its comments (# to the end of the line) and its tabs made blank: the board knows neither.
std::string without_comments(std::string_view text);
/// It sends an axis on its way: now, or when its turn comes in the queue.
bool begins_motion(Op op);
/// It says whom those behind it are for: AX to AS, AA, AM.
bool selects(const TextCommand& command);
/// What the command does to the context of those behind it.
void follow(const TextCommand& command, Context& context);

}  // namespace hw::vme58
