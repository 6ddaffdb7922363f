#pragma once
// Low-level lines from the statements of a text.
#include <vector>

#include "core/devices/arcus/language/parser.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

struct Generated {
  Program program;
  std::vector<int> source_line;             ///< for each low-level line the text's line
  int needed = 0;                           ///< low-level lines that the whole text needs
  const Statement* first_beyond = nullptr;  ///< the first statement that does not fit into program_lines
};

[[nodiscard]] Generated generate(const std::vector<Statement>& statements);

}  // namespace hw::arcus::language
