// Prints the manual page and the shell completions, both made from the tables of the command line.
#include "gui/app/cli.h"
#include "gui/app/completion.h"
#include "gui/app/manual_page.h"
#include "gui/app/output.h"

namespace hw::app {

static int reference(const Given& given) {
  using Write = std::string (*)();
  constexpr std::pair<std::string_view, Write> forms[] = {
      {"man", manual_page},
      {"bash", completion_for_bash},
      {"zsh", completion_for_zsh},
      {"fish", completion_for_fish},
  };
  for (const auto& [form, write] : forms)
    if (form == given.words[0]) return write_result(write()) ? done : failed;
  return complain(fmt::format("There is no form \"{}\". Choose man, bash, zsh or fish.", given.words[0]),
                  usage);
}

const Subcommand reference_subcommand{
    "reference",
    "the manual page, or the completion of a shell",
    {{"FORM", "man, bash, zsh or fish", 1, 1}},
    {},
    reference,
};

}  // namespace hw::app
