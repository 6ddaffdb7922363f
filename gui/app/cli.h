#pragma once
// The command line. Each subcommand declares its words and options, and its function receives them.
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/shown_text.h"

namespace hw::app {

enum Exit : int { done = 0, failed = 1, usage = 2 };

/// The arguments of a subcommand.
struct Given {
  std::vector<std::string> words;  ///< positionals, in order
  std::map<std::string, std::vector<std::string>>
      options;  ///< by name without dashes; a flag has an empty value

  /// Options with a value in the order of the command line, with an entry for each use.
  std::vector<std::pair<std::string, std::string>> in_order;

  [[nodiscard]] bool has(const std::string& name) const { return options.contains(name); }
  [[nodiscard]] std::string one(const std::string& name, std::string fallback = {}) const;
  [[nodiscard]] std::vector<std::string> all(const std::string& name) const;
  /// The number of an option, `fallback` without the option. A fault (wrong usage) unless it is a number from
  /// `low` to `high`.
  [[nodiscard]] Result<double> number(const std::string& name, double fallback, double low,
                                      double high) const;
};

struct OptionSpec {
  const char* name;         ///< "tcp"
  const char* placeholder;  ///< "HOST:PORT"; empty: a flag
  const char* help;
  bool repeatable = false;
  const char* shorter = "";  ///< "o"
};
struct WordSpec {
  const char* name;
  const char* help;
  int minimum, maximum;  ///< how many; maximum -1: any number
};

struct Subcommand {
  const char* name;
  const char* summary;
  std::vector<WordSpec> words;
  std::vector<OptionSpec> options;
  int (*run)(const Given& given);
};

/// All subcommands, in the order of the help.
std::span<const Subcommand* const> subcommands();
/// Options that are allowed before or after any subcommand.
std::span<const OptionSpec> general_options();

/// Parses the command line, runs the subcommand and returns the exit status.
int run_command_line(int argc, char** argv);

/// An address or option that is not understood is wrong usage; any other fault is a failed job.
inline Exit status_of(const Fault& fault) { return fault.kind == FaultKind::text ? usage : failed; }
/// Writes `sentence` to stderr and returns `status`. The sentence of a script may have several lines;
/// elsewhere a line end comes from a name and is written out.
int complain(std::string_view sentence, Exit status = failed, LineEnds ends = LineEnds::written_out);
int complain(const Fault& fault, Exit status = failed);

// Options of several subcommands.
inline constexpr OptionSpec model_option{"for", "MODEL", "the controller that the program is for"};
inline constexpr OptionSpec variant_option{
    "variant", "V", "model of the board (vme58): 8S, 4S4, 8, 4E, 2S2, 2S6, 6S2, 4S or 4"};
inline constexpr OptionSpec jumpers_option{
    "jumpers", "GGG", "its general lines 0-3, 4-7, 8-11 (vme58): I input, O output (default IIO)"};
inline constexpr OptionSpec json_option{"json", "", "print one JSON object"};
inline constexpr OptionSpec bench_option{"bench", "FILE.toml", "what surrounds the emulated controller"};

// Each subcommand has a cmd_*.cpp of its own.
extern const Subcommand open_subcommand, demo_subcommand, run_subcommand, emulate_subcommand, send_subcommand,
    check_subcommand, compile_subcommand, simulate_subcommand, convert_subcommand, scan_subcommand,
    backup_subcommand, restore_subcommand, params_subcommand, reference_subcommand;

}  // namespace hw::app
