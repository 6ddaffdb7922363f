#include "core/devices/arcus/program_language.h"

#include <utility>

#include "core/devices/arcus/language/compiler.h"

namespace hw::arcus {

ProgramReport analyse_program(std::string_view text, const language::Dialect& dialect) {
  language::Compilation compiled = language::compile(text, dialect);
  ProgramReport report;
  report.lines.reserve(compiled.text.size());
  for (language::SourceLine& from : compiled.text) {
    LineReport& line = report.lines.emplace_back();
    line.tokens = std::move(from.tokens);
    line.cost = line.command_count = from.count;
    line.first_command = from.first;
    if (from.count > 0) line.slot = 0;
  }
  report.cost[0] = compiled.needed;
  for (std::size_t n = 0; n < compiled.program.programs.size(); ++n)
    if (compiled.program.programs[n]) report.programs.push_back(static_cast<int>(n));
  const bool complete = compiled.ok();
  if (complete && !compiled.lines.empty()) report.listing[0] = std::move(compiled.lines);
  report.problems = std::move(compiled.problems);
  return report;
}

}  // namespace hw::arcus
