#include "gui/app/cli.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <fmt/core.h>

#include "core/base/log.h"

namespace hw::app {
namespace {

const OptionSpec model_option{"for", "MODEL",
                              "the controller that the program is for: vxm, pmx-4ex-sa, dmx-k-sa"};
const OptionSpec bench_option{"bench", "FILE.toml", "what surrounds the emulated controller"};

const std::vector<Subcommand>& subcommands() {
  static const std::vector<Subcommand> all = {
      {"open",
       "the console (also without any subcommand)",
       {{"ADDRESS", "controllers to open; none: the connection page", 0, -1}},
       {},
       open_console},
      {"demo",
       "the console with emulated controllers; without a display a headless demonstration",
       {},
       {{"pictures", "FOLDER",
         "where the headless demonstration leaves its pictures (default: demo beside the program)"},
        {"headless", "", "no window even where there is a display"}},
       demo},
      {"run",
       "run a Lua script without a window",
       {{"SCRIPT.lua", "the script", 1, 1}, {"ARGS", "its hw.args; -- ends the options", 0, -1}},
       {{"realtime", "",
         "wall-clock time (else virtual time while every controller is an emulator in process)"},
        {"gui", "", "with the panels, laid out and driven without a display"},
        {"traffic", "FILE", "write down every byte of every wire"}},
       run_script},
      {"emulate",
       "serve an emulated controller to other programs until interrupted",
       {{"MODEL", "vxm, pmx-4ex-sa or dmx-k-sa", 1, 1}},
       {{"tcp", "HOST:PORT", "listen there; port 0: any free one", true},
        {"pty", "PATH", "make a pseudo-terminal and this symlink to it", true},
        {"id", "NN", "number on its line, two digits; several: that many controllers on one line", true},
        {"motors", "N", "number of motors; 3 or 4: a Master with its Slave linked"},
        {"speed", "X", "so many times faster than real time (default 1)"},
        {"wire", "real|off", "spend the byte times of the baud rate (default: real with a --pty, else off)"},
        {"quirk", "NAME", "a habit of certain units: overrun, e-bar", true},
        {"state", "FILE", "keep the non-volatile memory there; with several --id in FILE.NN of each"},
        bench_option,
        {"allow-remote", "", "let other hosts connect (else only this one)"}},
       emulate},
      {"send",
       "send each TEXT as one command, print each reply on a line",
       {{"ADDRESS", "the controller", 1, 1}, {"TEXT", "a command of the controller", 1, -1}},
       {{"wait", "SECONDS", "how long a reply may take (default: what the command and the wire need)"}},
       send},
      {"check",
       "look a program over without running it",
       {{"FILE", "the program", 1, 1}},
       {model_option},
       check},
      {"compile",
       "make of a program what the controller stores",
       {{"FILE", "the program", 1, 1}},
       {model_option,
        {"output", "OUT", "the file for the stored form", false, "o"},
        {"listing", "", "show the stored form"}},
       compile},
      {"simulate",
       "dry run of a program, in virtual time",
       {{"FILE", "the program", 1, 1}},
       {model_option,
        {"json", "", "one JSON object instead of words"},
        bench_option,
        {"for-seconds", "N", "stop a program that does not end by then (default 3600, simulated)"}},
       simulate},
      {"scan",
       "serial ports, USB devices, and which controllers answer on them; moves nothing",
       {{"PORT", "serial ports to ask; none: all that there are", 0, -1}},
       {{"ids", "NN-NN",
         "search each of these numbers on lines that several share, at each rate (default: the usual number "
         "only)"},
        {"baud", "RATE", "with --ids: only at this rate", true}},
       scan},
      {"backup",
       "set-up and programs of a controller into a file",
       {{"ADDRESS", "the controller", 1, 1}},
       {{"output", "FILE.toml", "the file", false, "o"}},
       backup},
      {"restore",
       "set-up and programs from a file into a controller",
       {{"ADDRESS", "the controller", 1, 1}, {"FILE.toml", "made by backup", 1, 1}},
       {{"leave-motor-types", "", "leave parameters that carry a warning (motor types) as they are"}},
       restore},
  };
  return all;
}

// One subcommand as CLI11 sees it, and where it puts what it finds.
struct Parsed {
  const Subcommand* command;
  CLI::App* app;
  std::vector<std::vector<std::string>> words;
  std::map<std::string, std::vector<std::string>> values;
  std::map<std::string, CLI::Option*> options;
};

void add_words(Parsed& parsed) {
  const auto& specs = parsed.command->words;
  parsed.words.resize(specs.size());
  for (std::size_t i = 0; i < specs.size(); ++i) {
    auto* option = parsed.app->add_option(specs[i].name, parsed.words[i], specs[i].help);
    option->type_name("")->allow_extra_args(specs[i].maximum != 1);
    option->expected(specs[i].minimum,
                     specs[i].maximum < 0 ? CLI::detail::expected_max_vector_size : specs[i].maximum);
    if (specs[i].minimum > 0) option->required();
  }
}

void add_options(Parsed& parsed) {
  for (const OptionSpec& spec : parsed.command->options) {
    std::string names = fmt::format("--{}", spec.name);
    if (*spec.shorter) names = fmt::format("-{},{}", spec.shorter, names);
    CLI::Option* option = nullptr;
    if (*spec.placeholder) {
      option = parsed.app->add_option(names, parsed.values[spec.name], spec.help);
      option->type_name(spec.placeholder)->expected(1)->allow_extra_args(false);
      option->multi_option_policy(spec.repeatable ? CLI::MultiOptionPolicy::TakeAll
                                                  : CLI::MultiOptionPolicy::Throw);
    } else {
      option = parsed.app->add_flag(names, spec.help);
    }
    parsed.options[spec.name] = option;
  }
}

Given collect(const Parsed& parsed, std::vector<std::string> behind_dashes) {
  Given given;
  for (const auto& words : parsed.words) given.words.insert(given.words.end(), words.begin(), words.end());
  given.words.insert(given.words.end(), behind_dashes.begin(), behind_dashes.end());
  for (const auto& [name, option] : parsed.options) {
    if (option->count() == 0) continue;
    const auto values = parsed.values.find(name);
    given.options[name] = values == parsed.values.end() ? std::vector<std::string>{""} : values->second;
  }
  std::map<std::string, std::size_t> taken;
  for (const CLI::Option* option : parsed.app->parse_order())
    for (const auto& [name, values] : parsed.values)
      if (parsed.options.at(name) == option && taken[name] < values.size())
        given.in_order.emplace_back(name, values[taken[name]++]);
  return given;
}

constexpr const char* footer =
    "An address is MODEL@TRANSPORT[:WHERE][,key=value...]:\n"
    "  vxm@emulator            an emulator in this process (motors=4: with a Slave)\n"
    "  vxm@serial:/dev/ttyUSB0,baud=9600\n"
    "  dmx-k-sa@serial:/dev/ttyUSB0,baud=9600,id=01   pmx-4ex-sa@usb\n"
    "  vxm@tcp:HOST:PORT       vxm@rfc2217:HOST:PORT,baud=9600\n"
    "Exit status: 0 done, 1 the job failed (with a sentence), 2 wrong usage.";

}  // namespace

std::string Given::one(const std::string& name, std::string fallback) const {
  const auto found = options.find(name);
  return found == options.end() || found->second.empty() ? fallback : found->second.back();
}
std::vector<std::string> Given::all(const std::string& name) const {
  const auto found = options.find(name);
  return found == options.end() ? std::vector<std::string>{} : found->second;
}
Result<double> Given::number(const std::string& name, double fallback, double low, double high) const {
  if (!has(name)) return fallback;
  const std::string text = one(name);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0' && std::isfinite(value) && value >= low && value <= high) return value;
  return fail(FaultKind::text, fmt::format("--{} {} is not possible.", name, text), {},
              fmt::format("Give a number from {} to {}.", low, high));
}

int complain(std::string_view sentence, Exit status) {
  fmt::print(stderr, "handwheel: {}\n", sentence);
  return status;
}
int complain(const Fault& fault, Exit status) { return complain(fault.sentence(), status); }

int run_command_line(int argc, char** argv) {
  CLI::App app("Handwheel: a console for motion controllers, real or emulated.", "handwheel");
  app.set_version_flag("--version", "handwheel " HW_VERSION);
  app.footer(footer);
  app.require_subcommand(0, 1);
  bool verbose = false;
  app.add_flag("--verbose", verbose, "more log lines on stderr");

  std::vector<Parsed> parsed;
  parsed.reserve(subcommands().size());
  for (const Subcommand& command : subcommands()) {
    Parsed& one = parsed.emplace_back();
    one.command = &command;
    one.app = app.add_subcommand(command.name, command.summary);
    one.app->fallthrough();
    add_words(one);
    add_options(one);
  }

  // What stands behind -- is never an option.
  std::vector<std::string> words(argv + 1, argv + argc), behind_dashes;
  if (const auto dashes = std::find(words.begin(), words.end(), "--"); dashes != words.end()) {
    behind_dashes.assign(dashes + 1, words.end());
    words.erase(dashes, words.end());
  }
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : usage;
  }
  if (verbose) log::set_level(log::Level::debug);
  for (const Parsed& one : parsed)
    if (one.app->parsed()) return one.command->run(collect(one, std::move(behind_dashes)));
  return open_console({});
}

}  // namespace hw::app
