#pragma once
// The places in a program's text that a path can come from: a line, or a command if several commands of a
// line move axes. Pure.
#include <string_view>
#include <vector>

#include "core/device/language.h"

namespace hw::panels {

struct SourcePlace {
  int line = 0, byte = 0;  ///< from 0
};

struct SourcePlaces {
  std::vector<SourcePlace> all;  ///< by source of a run, in text order
  std::vector<int> of_command;   ///< like lines_of_commands(), but as index into `all`; -1: none

  struct IndexRange {
    int first = -1, count = 0;
  };
  /// The places of a line. -1: it has no commands.
  [[nodiscard]] IndexRange of_line(int line) const;
  /// The line of a source; -1: no such source.
  [[nodiscard]] int line_of(int source) const;
  /// The text of a source: from its place to the next place of its line, or to the end of the line.
  [[nodiscard]] std::string_view command_of(int source, std::string_view text) const;
};

SourcePlaces source_places(const ProgramReport& report, int slot);

}  // namespace hw::panels
