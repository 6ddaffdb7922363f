#include <fmt/format.h>

#include "core/base/shown_text.h"
#include "core/device/registry.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/program_file.h"

namespace hw::app {

static int check(const Given& given) {
  const auto program = read_program(given);
  if (!program) return complain(program.error(), status_of(program.error()));
  const ProgramReport report = program->language->analyse(program->text, 0);
  for (const std::string& line : problem_lines(*program, report)) print_result("{}\n", line);
  if (report.has_errors()) return failed;
  const ProgramFacts& facts = program->catalog.program;
  const std::string path = shown_path(program->path);
  const std::string of = facts.capacity > 0 ? fmt::format(" of {}", facts.capacity) : std::string();
  for (const auto& [slot, cost] : report.cost) {
    if (facts.threads > 0 && report.programs.empty()) {  // only subroutines, or nothing
      print_result("{}: no program in it, {}{} {}\n", path, cost, of, facts.capacity_unit);
      continue;
    }
    const std::vector<int> numbers = report.programs.empty() ? std::vector<int>(1, slot) : report.programs;
    print_result("{}: {}{} {}: {}{} {}\n", path, facts.slot_word, numbers.size() > 1 ? "s" : "",
                 fmt::join(numbers, ", "), cost, of, facts.capacity_unit);
  }
  return done;
}

const Subcommand check_subcommand{
    "check", "check a program without running it", {{"FILE", "the program", 1, 1}}, {model_option}, check,
};

}  // namespace hw::app
