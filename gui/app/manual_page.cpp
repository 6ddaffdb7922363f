#include "gui/app/manual_page.h"

#include <fmt/core.h>

#include "core/device/registry.h"
#include "core/session/transport_list.h"
#include "gui/app/cli.h"
#include "gui/app/version.h"

namespace hw::app {
namespace {

/// Escapes a text, so that no dash becomes a hyphen and no line begins a request.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool at_start = out.empty() || out.back() == '\n';
    if (at_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", plain(text)); }
std::string slanted(std::string_view text) { return fmt::format("\\fI{}\\fR", plain(text)); }

std::string names_of(const OptionSpec& option) {
  std::string names = *option.shorter ? bold(fmt::format("-{}", option.shorter)) + ", " : "";
  names += bold(fmt::format("--{}", option.name));
  return *option.placeholder ? names + " " + slanted(option.placeholder) : names;
}

void put_options(std::string& page, std::span<const OptionSpec> options) {
  for (const OptionSpec& option : options)
    page += fmt::format(".TP\n{}\n{}{}\n", names_of(option), plain(option.help),
                        option.repeatable ? " (may be given again)" : "");
}

std::string synopsis(const Subcommand& command) {
  std::string line = bold(fmt::format("handwheel {}", command.name));
  for (const WordSpec& word : command.words) {
    const std::string name = slanted(word.name) + (word.maximum == 1 ? "" : "...");
    line += word.minimum == 0 ? fmt::format(" [{}]", name) : " " + name;
  }
  return command.options.empty() ? line : line + " [options]";
}

void put_commands(std::string& page) {
  page += ".SH COMMANDS\n";
  for (const Subcommand* command : subcommands()) {
    page += fmt::format(".SS {}\n{}\n", synopsis(*command), plain(command->summary));
    for (const WordSpec& word : command->words)
      page += fmt::format(".TP\n{}\n{}\n", slanted(word.name), plain(word.help));
    put_options(page, command->options);
  }
}

void put_addresses(std::string& page) {
  page += fmt::format(".SH ADDRESSES\nAn address is {}, as\n{} or\n{}.\nThe models:\n",
                      slanted("MODEL@TRANSPORT[:WHERE][,key=value...]"), bold("vxm@emulator"),
                      bold("dmx-k-sa@serial:/dev/ttyUSB0,baud=9600,id=01-04"));
  for (const DeviceType& type : device_types()) {
    const auto catalog = type.make_catalog({});
    page += fmt::format(".TP\n{}\n{}\n", bold(type.model),
                        catalog ? plain(fmt::format("{}: {}", catalog->name, catalog->summary)) : "");
  }
  page += ".PP\nThe transports:\n";
  for (const TransportInfo& way : transports()) {
    const std::string where = way.example.empty() ? "" : fmt::format(":{}", way.example);
    page += fmt::format(".TP\n{}\n{}\n", bold(fmt::format("{}{}", way.name, where)), plain(way.title));
  }
}

constexpr std::string_view ending = R"(.SH EXIT STATUS
.TP
0
The job is done.
.TP
1
The job failed; a sentence on standard error says why.
.TP
2
Wrong usage.
.SH FILES
.TP
\fI$XDG_CONFIG_HOME/handwheel\fR, or \fI~/.config/handwheel\fR
Names, units, limits and places of each controller.
.TP
\fI$XDG_STATE_HOME/handwheel\fR, or \fI~/.local/state/handwheel\fR
Unsaved texts, last connections, sizes of the window, and the log (\fIhandwheel.log\fR).
.TP
\fI/usr/share/handwheel\fR
The manual and the examples.
)";

}  // namespace

std::string manual_page() {
  std::string page = fmt::format(".TH HANDWHEEL 1 \"\" \"Handwheel {}\" \"User Commands\"\n", HW_VERSION);
  page += ".SH NAME\nhandwheel \\- console for motion controllers, real or emulated\n.SH SYNOPSIS\n";
  for (const Subcommand* command : subcommands()) page += synopsis(*command) + "\n.br\n";
  page +=
      ".SH DESCRIPTION\nWithout a command, or with the command open, the console opens a window. The other "
      "commands "
      "do their job in\nthe terminal. Results go to standard output, everything else to standard error.\n";
  put_addresses(page);
  put_commands(page);
  page += ".SH OPTIONS\nThese options go with every command.\n";
  put_options(page, general_options());
  page += ".TP\n\\fB\\-\\-help\\fR\nwhat a command takes\n.TP\n\\fB\\-\\-version\\fR\nversion and commit\n";
  return page.append(ending);
}

}  // namespace hw::app
