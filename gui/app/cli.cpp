#include "gui/app/cli.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <fmt/core.h>

#include "core/base/log.h"
#include "core/base/near_name.h"
#include "core/device/registry.h"
#include "core/session/address.h"
#include "core/session/assets.h"
#include "gui/app/output.h"
#include "gui/app/version.h"

namespace hw::app {
namespace {

const Subcommand* const all_subcommands[] = {
    &open_subcommand,   &demo_subcommand,    &run_subcommand,      &emulate_subcommand,   &send_subcommand,
    &check_subcommand,  &compile_subcommand, &simulate_subcommand, &convert_subcommand,   &scan_subcommand,
    &backup_subcommand, &restore_subcommand, &params_subcommand,   &reference_subcommand,
};

constexpr OptionSpec for_all[] = {
    {"verbose", "", "more log lines on stderr"},
    {"log", "SUBJECT=LEVEL", "log a subject (link, pump, driver.vxm, gui) from a level up (debug, info, ...)",
     true},
};

/// The help of an argument; for a MODEL with the known models.
std::string help_of(std::string_view name, std::string_view help) {
  return name == "MODEL" ? fmt::format("{}: {}", help, known_models()) : std::string(help);
}

// CLI11 splits "[a,b]" and takes words that begin with a dash for options. This mark before a word makes
// CLI11 take it literally.
constexpr char as_it_stands = '\x01';

std::string marked(std::string word) { return as_it_stands + std::move(word); }
std::string unmarked(std::string word) {
  if (word.starts_with(as_it_stands)) word.erase(0, 1);
  return word;
}

/// The words in CLI11's order, the last first. A word after -- is never an option.
std::vector<std::string> words_for_parser(int argc, char** argv) {
  std::vector<std::string> words;
  bool behind_dashes = false;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (!behind_dashes && word == "--")
      behind_dashes = true;
    else
      words.push_back(behind_dashes || word.starts_with('[') ? marked(std::move(word)) : std::move(word));
  }
  std::reverse(words.begin(), words.end());
  return words;
}

// A subcommand for CLI11, and its results.
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
    auto* option =
        parsed.app->add_option(specs[i].name, parsed.words[i], help_of(specs[i].name, specs[i].help));
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
      option = parsed.app->add_option(names, parsed.values[spec.name], help_of(spec.placeholder, spec.help));
      option->type_name(spec.placeholder)->expected(1)->allow_extra_args(false);
      option->multi_option_policy(spec.repeatable ? CLI::MultiOptionPolicy::TakeAll
                                                  : CLI::MultiOptionPolicy::Throw);
    } else {
      option = parsed.app->add_flag(names, spec.help);
    }
    parsed.options[spec.name] = option;
  }
}

Given collect(Parsed& parsed) {
  Given given;
  for (const auto& words : parsed.words)
    for (const std::string& word : words) given.words.push_back(unmarked(word));
  for (auto& [name, values] : parsed.values)
    for (std::string& value : values) value = unmarked(std::move(value));
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

/// The command whose help to show: "handwheel send", or "handwheel" alone.
std::string asked_for(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* one : app.get_subcommands()) name += " " + one->get_name();
  return name;
}

std::string no_subcommand(std::string_view wanted) {
  std::vector<std::string> names;
  for (const Subcommand* one : all_subcommands) names.emplace_back(one->name);
  const std::string_view meant = near_name(wanted, names);
  return fmt::format("There is no subcommand \"{}\"{}", wanted,
                     meant.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", meant));
}

std::string why_not(const CLI::App& app, const CLI::ParseError& error, std::string_view first) {
  if (app.get_subcommands().empty() && !first.starts_with('-')) return no_subcommand(first);
  std::string why = error.what();
  std::erase(why, as_it_stands);
  return why;
}

constexpr const char* footer =
    "An address is MODEL@TRANSPORT[:WHERE][,key=value...]:\n"
    "  vxm@emulator            an emulator in this process (motors=4: with a Slave)\n"
    "  vxm@serial:/dev/ttyUSB0,baud=9600\n"
    "  dmx-k-sa@serial:/dev/ttyUSB0,baud=9600,id=01   pmx-4ex-sa@usb\n"
    "  vxm@tcp:HOST:PORT       vxm@rfc2217:HOST:PORT,baud=9600\n"
    "Exit status: 0 done, 1 the job failed (with a sentence), 2 wrong usage.";

std::string where_to_read_on() {
  const auto manual = find_asset("manual");
  return manual.empty() ? "" : fmt::format("\nManual and examples: {}.", manual.parent_path().string());
}

/// Without this check `driver.vmx=debug` would silently log nothing.
Result<> check_models(std::string_view choices) {
  constexpr std::string_view of_a_driver = "driver.";
  for (std::size_t from = 0; from <= choices.size();) {
    const std::size_t comma = std::min(choices.find(',', from), choices.size());
    const std::string_view path = choices.substr(from, std::min(choices.find('=', from), comma) - from);
    if (path.starts_with(of_a_driver))
      if (const auto model = path.substr(of_a_driver.size()); !find_device_type(model)) {
        Fault unknown = unknown_model(model);
        unknown.what.insert(0, "--log: ");
        return fail(std::move(unknown));
      }
    from = comma + 1;
  }
  return {};
}

Result<> choose_logs(const Given& given) {
  if (given.has("verbose")) log::set_level("", log::Level::debug);
  for (const std::string& choice : given.all("log")) {
    if (auto understood = log::choose(choice); !understood) return understood;
    if (auto known = check_models(choice); !known) return known;
  }
  return {};
}

/// --help, --version.
int fulfil(const CLI::App& app, const CLI::Success& request) {
  std::ostringstream output;
  const int status = app.exit(request, output, output);
  write_result(output.str());
  return status == 0 ? done : usage;
}

/// The status fails if a result could not be written.
int status_with_output(int status) {
  if (!output_is_lost() || status == usage) return status;
  return output_loss_is_reported() ? failed : complain(output_loss());
}

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

std::span<const Subcommand* const> subcommands() { return all_subcommands; }
std::span<const OptionSpec> general_options() { return for_all; }

int complain(std::string_view sentence, Exit status, LineEnds ends) {
  constexpr std::size_t longest = 4000;  // it may contain words of the command line, a file or a wire
  write_aside(fmt::format("handwheel: {}", shown_text(sentence, longest, ends)));
  return status;
}
int complain(const Fault& fault, Exit status) { return complain(fault.sentence(), status); }

int run_command_line(int argc, char** argv) {
  CLI::App app("Handwheel: a console for motion controllers, real or emulated.", "handwheel");
  app.set_version_flag("--version", "handwheel " + version());
  app.footer(fmt::format("{}{}", footer, where_to_read_on()));
  app.require_subcommand(0, 1);
  Subcommand general{"", "", {}, {std::begin(for_all), std::end(for_all)}, nullptr};
  Parsed of_all{&general, &app, {}, {}, {}};
  add_options(of_all);

  std::vector<Parsed> parsed;
  parsed.reserve(std::size(all_subcommands));
  for (const Subcommand* command : all_subcommands) {
    Parsed& one = parsed.emplace_back();
    one.command = command;
    one.app = app.add_subcommand(command->name, command->summary);
    one.app->fallthrough();
    add_words(one);
    add_options(one);
  }

  try {
    app.parse(words_for_parser(argc, argv));
  } catch (const CLI::Success& request) {  // --help, --version
    return status_with_output(fulfil(app, request));
  } catch (const CLI::ParseError& error) {
    return complain(
        fmt::format("{}. `{} --help` shows the usage.", why_not(app, error, argv[1]), asked_for(app)), usage);
  }
  if (auto chosen = choose_logs(collect(of_all)); !chosen) return complain(chosen.error(), usage);
  for (Parsed& one : parsed)
    if (one.app->parsed()) return status_with_output(one.command->run(collect(one)));
  return open_subcommand.run({});
}

}  // namespace hw::app
