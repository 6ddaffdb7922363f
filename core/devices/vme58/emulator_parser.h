#pragma once
// Parses text one character at a time: two letters and operands, with or without separators (decisions M12,
// M15, M16). A command without operands is complete with its second letter, a number with the character after
// it.
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/devices/vme58/command_facts.h"

namespace hw::vme58 {

/// A command as typed: its numbers are neither checked nor multiplied. They are indexed by axis in a list,
/// else by order.
struct Command {
  const CommandFact* fact = nullptr;
  std::array<std::optional<double>, most_axes> number{};
  int source = 0;  ///< origin of the text, for notes (emulator_notes.h)

  [[nodiscard]] Op op() const { return fact->op; }
  [[nodiscard]] int operands() const {
    int count = 0;
    for (const auto& n : number) count += n.has_value();
    return count;
  }
  /// Queue entries that the command takes.
  [[nodiscard]] int entries() const { return 1 + operands(); }
  [[nodiscard]] double first() const { return number[0].value_or(0); }
};

class Parser {
 public:
  explicit Parser(bool knows_kk = false) : knows_kk_(knows_kk) {}

  struct Outcome {
    bool error = false;
    std::optional<Command> command;
  };
  /// `modes`: those in force, of namespace where. One character can both complete a command or error and
  /// begin the next command; it never completes two commands.
  Outcome push(char c, unsigned modes);
  /// Discards an unfinished command.
  void clear() { *this = Parser(knows_kk_); }

 private:
  enum class State : std::uint8_t { idle, second_letter, numbers, skipping };

  Outcome begin(char c);
  Outcome second(char c, unsigned modes);
  Outcome number(char c);
  Outcome junk();
  [[nodiscard]] bool takes_list() const;
  [[nodiscard]] int places() const;
  /// Stores the typed number at its place; false: it is not a number.
  bool keep_number();
  Outcome next_place();
  Outcome finish();

  bool knows_kk_;  ///< quirk oms-kk
  State state_ = State::idle;
  char first_ = 0;
  unsigned modes_ = 0;
  Command command_;
  int place_ = 0;
  std::string text_;     ///< of the number being typed
  bool closed_ = false;  ///< a space followed the number
};

}  // namespace hw::vme58
