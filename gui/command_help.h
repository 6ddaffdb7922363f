#pragma once
// What the catalog knows of a line that is being typed for the wire: how it can go on, and what Enter would
// do.
#include <string>
#include <string_view>
#include <vector>

#include "core/device/catalog.h"

namespace hw::gui {

class CommandHelp {
 public:
  explicit CommandHelp(const std::vector<CommandInfo>& commands);

  struct Hint {
    std::string
        sentence;        ///< "speed of motor m, 1 to 6000 steps/s. Stored in the program, moves nothing now"
    bool moves = false;  ///< Enter would, or might, move something
    bool unknown = false;  ///< nothing of the catalog begins so
  };
  /// For the whole line: help of its last command; whether any of its commands moves.
  [[nodiscard]] Hint hint(std::string_view line) const;

  /// Commands that the last one in the line can become, best first: indices into the catalog.
  [[nodiscard]] std::vector<std::size_t> candidates(std::string_view line) const;
  /// The line with as much added as all candidates share. Unchanged: nothing to add.
  [[nodiscard]] std::string complete(std::string_view line) const;
  /// The line with its last command replaced by the start of this candidate.
  [[nodiscard]] std::string with(std::string_view line, std::size_t command) const;

 private:
  struct Part {
    char literal = 0;  ///< 0: digits stand here
    bool one_digit = false;
  };
  struct Form {
    std::vector<Part> parts;
    std::string head;  ///< literal beginning
  };
  enum class Match { none, begins, whole };
  static Form form_of(const CommandInfo& command);
  static Match match(const Form& form, std::string_view text);
  static std::string_view last_command(std::string_view line);

  const std::vector<CommandInfo>& commands_;
  std::vector<Form> forms_;
};

}  // namespace hw::gui
