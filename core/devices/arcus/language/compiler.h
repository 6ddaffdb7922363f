#pragma once
// From the text of a program to its low-level lines: lexer, parser, structure, code generator in a row.
#include <string>
#include <string_view>
#include <vector>

#include "core/device/language.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

/// The result of one line of the text.
struct SourceLine {
  std::vector<Token> tokens;
  int first = -1;  ///< its first low-level line; -1: none
  int count = 0;   ///< low-level lines
};

struct Compilation {
  Program program;                 ///< the lines that could be compiled; complete if there are no errors
  std::vector<std::string> lines;  ///< `program` as low-level lines, for SA
  std::vector<int> source_line;    ///< for each low-level line the text's line, from 0
  int needed = 0;                  ///< low-level lines of the whole text; may be more than there are
  std::vector<SourceLine> text;    ///< one for each line of the text
  std::vector<Problem> problems;   ///< in the order of the text
  [[nodiscard]] bool ok() const {
    for (const Problem& p : problems)
      if (p.error) return false;
    return true;
  }
};

/// `text`: a program as a person writes it, or a listing (listing.h).
[[nodiscard]] Compilation compile(std::string_view text, const Dialect& dialect);

}  // namespace hw::arcus::language
