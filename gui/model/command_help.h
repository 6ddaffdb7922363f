#pragma once
// The catalog's help for a line that is being typed for the wire: its completions, and what Enter would do.
#include <string>
#include <string_view>
#include <vector>

#include "core/device/command_form.h"

namespace hw::gui {

class CommandHelp {
 public:
  explicit CommandHelp(const Catalog& catalog);

  struct Hint {
    std::string
        sentence;        ///< "speed of motor m, 1 to 6000 steps/s. Stored in the program, moves nothing now"
    bool moves = false;  ///< Enter would, or might, cause a motion
    bool unknown = false;  ///< no command of the catalog begins like this
  };
  /// For the whole line: help for its last command, and whether any of its commands causes a motion.
  [[nodiscard]] Hint hint(std::string_view line) const;

  /// Completions of the line's last command, best first: indices into the catalog.
  [[nodiscard]] std::vector<std::size_t> candidates(std::string_view line) const;
  /// The line, extended as far as all candidates agree. Unchanged: nothing to add.
  [[nodiscard]] std::string complete(std::string_view line) const;
  /// The line with its last command replaced by the beginning of this candidate.
  [[nodiscard]] std::string with(std::string_view line, std::size_t command) const;

 private:
  using Match = CommandForm::Match;
  [[nodiscard]] std::string_view last_command(std::string_view line) const;

  const std::vector<CommandInfo>& commands_;
  const std::string& separators_;
  std::vector<CommandForm> forms_;
};

}  // namespace hw::gui
