#pragma once
// The command line. Each subcommand declares its words and options; its function receives them.
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
      options;  ///< by name without dashes; flags: one empty value

  /// Options with a value, one entry per use, in the order of the command line.
  std::vector<std::pair<std::string, std::string>> in_order;

  [[nodiscard]] bool has(const std::string& name) const { return options.contains(name); }
  [[nodiscard]] std::string one(const std::string& name, std::string fallback = {}) const;
  [[nodiscard]] std::vector<std::string> all(const std::string& name) const;
  /// A fault (wrong usage) unless it is a number from `low` to `high`.
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

/// In the order of the help.
std::span<const Subcommand* const> subcommands();
/// Options allowed before or after any subcommand.
std::span<const OptionSpec> general_options();

/// Parses, runs the subcommand, returns the exit status.
int run_command_line(int argc, char** argv);

/// A text without meaning (an address, an option) is wrong usage; every other fault is a failed job.
inline Exit status_of(const Fault& fault) { return fault.kind == FaultKind::text ? usage : failed; }
/// Writes `sentence` to stderr and returns `status`. Of a script it may have several lines; elsewhere a line
/// end comes from a name, and is written out.
int complain(std::string_view sentence, Exit status = failed, LineEnds ends = LineEnds::written_out);
int complain(const Fault& fault, Exit status = failed);

// Options of several subcommands.
inline constexpr OptionSpec model_option{"for", "MODEL", "the controller that the program is for"};
inline constexpr OptionSpec bench_option{"bench", "FILE.toml", "what surrounds the emulated controller"};

// Each in its own cmd_*.cpp.
extern const Subcommand open_subcommand, demo_subcommand, run_subcommand, emulate_subcommand, send_subcommand,
    check_subcommand, compile_subcommand, simulate_subcommand, convert_subcommand, scan_subcommand,
    backup_subcommand, restore_subcommand, params_subcommand, reference_subcommand;

}  // namespace hw::app
