#include <fmt/core.h>

#include "core/device/language.h"
#include "core/session/text_file.h"
#include "core/session/user_files.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/program_file.h"

namespace hw::app {

static int compile(const Given& given) {
  const auto program = read_program(given);
  if (!program) return complain(program.error(), program.error().kind == FaultKind::text ? usage : failed);
  if (!program->catalog.program.compiled)
    return complain(
        fmt::format("Programs of the {} are stored as they are written: there is nothing to compile. "
                    "`check` checks them.",
                    program->catalog.name));
  const ProgramReport report = program->language->analyse(program->text, 0);
  for (const std::string& line : problem_lines(*program, report)) write_aside(line);
  if (report.has_errors()) return failed;
  const auto lines = report.listing.find(0);
  const std::string listing = program->language->write_listing(
      lines == report.listing.end() ? std::vector<std::string>() : lines->second);
  if (given.has("listing")) write_result(listing);
  if (!given.has("output")) {
    if (given.has("listing")) return done;
    return complain("Add -o OUT to write it to a file, or --listing to see it.", usage);
  }
  if (auto written = write_file(given.one("output"), listing); !written) return complain(written.error());
  const auto cost = report.cost.find(0);
  print_result("{}: {} of {} {}\n", given.one("output"), cost == report.cost.end() ? 0 : cost->second,
               program->catalog.program.capacity, program->catalog.program.capacity_unit);
  return done;
}

const Subcommand compile_subcommand{
    "compile",
    "compile a program into the form that the controller stores",
    {{"FILE", "the program", 1, 1}},
    {model_option,
     {"output", "OUT", "the file for the stored form", false, "o"},
     {"listing", "", "show the stored form"}},
    compile,
};

}  // namespace hw::app
