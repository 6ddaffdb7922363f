#pragma once
// The text of a program read from a controller, as a person would write it.
#include <string>
#include <vector>

#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus::language {

struct Decompiled {
  std::string text;                ///< compiles to the same lines when none of them is bad
  std::vector<int> source_line;    ///< for each low-level line its line in `text`
  std::vector<BadLine> bad_lines;  ///< they stand in `text` as comments, `;? line`
};

/// Unused lines at the end do not count.
[[nodiscard]] Decompiled decompile(const std::vector<std::string>& lines, const Dialect& dialect);

/// The text of program `number` alone, without subroutines; empty: there is none.
[[nodiscard]] std::string program_alone(const std::vector<std::string>& lines, const Dialect& dialect,
                                        int number);

/// One statement in the maker's form: "HOMEX+", "V2=V1+1".
[[nodiscard]] std::string source_of(const Instruction& statement, const Dialect& dialect);

}  // namespace hw::arcus::language
