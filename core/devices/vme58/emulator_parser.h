#pragma once
// Text to commands, one character at a time: two letters and operands, with or without separators (decisions
// M12, M15, M16). A command without operands is complete with its second letter, a number with the character
// behind it.
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/devices/vme58/command_facts.h"

namespace hw::vme58 {

/// A command as it was typed: its numbers are neither checked nor multiplied. By place: the axis of a list,
/// else the order.
struct Command {
  const CommandFact* fact = nullptr;
  std::array<std::optional<double>, most_axes> number{};
  int source = 0;  ///< where it comes from, for who listens (emulator_notes.h)

  [[nodiscard]] Op op() const { return fact->op; }
  [[nodiscard]] int operands() const {
    int count = 0;
    for (const auto& n : number) count += n.has_value();
    return count;
  }
  /// Entries of a queue that it takes.
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
  /// `modes`: those of namespace where that are in force. Both an outcome of what came before and the begin
  /// of something new can lie in one character; never two commands.
  Outcome push(char c, unsigned modes);
  /// Forgets what has been begun.
  void clear() { *this = Parser(knows_kk_); }

 private:
  enum class State : std::uint8_t { idle, second_letter, numbers, skipping };

  Outcome begin(char c);
  Outcome second(char c, unsigned modes);
  Outcome number(char c);
  Outcome junk();
  [[nodiscard]] bool takes_list() const;
  [[nodiscard]] int places() const;
  /// The number that is being typed goes to its place; false: it is none.
  bool keep_number();
  Outcome next_place();
  Outcome finish();

  bool knows_kk_;  ///< quirk oms-kk
  State state_ = State::idle;
  char first_ = 0;
  unsigned modes_ = 0;
  Command command_;
  int place_ = 0;
  std::string text_;     ///< of the number that is being typed
  bool closed_ = false;  ///< a space stands behind it
};

}  // namespace hw::vme58
