#pragma once
// What a path can come of in a program's text: a line, or, where several commands of one line move something,
// a command. Pure.
#include <string_view>
#include <vector>

#include "core/device/language.h"

namespace hw::panels {

struct SourcePlace {
  int line = 0, byte = 0;  ///< from 0
};

struct SourcePlaces {
  std::vector<SourcePlace> all;  ///< by the source of a run, in the order of the text
  std::vector<int> of_command;   ///< as lines_of_commands(), but which of `all`; -1: of none

  struct Some {
    int first = -1, count = 0;
  };
  /// Those of a line. -1: it commands nothing.
  [[nodiscard]] Some of_line(int line) const;
  /// -1: there is no such.
  [[nodiscard]] int line_of(int source) const;
  /// Of their text: the line from there up to the next that it holds.
  [[nodiscard]] std::string_view command_of(int source, std::string_view text) const;
};

SourcePlaces source_places(const ProgramReport& report, int slot);

}  // namespace hw::panels
