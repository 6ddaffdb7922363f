#pragma once
// A script's command-line arguments: parsing and help. Pure.
//   PLACE          required: by its place, as it has no default
//   --name VALUE   or --name=VALUE, or name=VALUE; a flag stands alone
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace hw::script {

struct Argument {
  enum class Kind { text, number, whole, flag };
  std::string name;
  Kind kind = Kind::text;
  bool required = false;
  std::string fallback;  ///< as typed; empty: none
  std::string help;
  std::vector<std::string> choices;  ///< empty: any
};

struct GivenArguments {
  bool wants_help = false;
  std::map<std::string, std::string> values;  ///< by name; empty for a flag
};

/// `word`: "number". A fault: no such kind.
Result<Argument::Kind> argument_kind(const std::string& word);
/// A fault names the wrong word and what was expected.
Result<GivenArguments> read_arguments(const std::vector<Argument>& known,
                                      const std::vector<std::string>& words);
/// The usage line and a line for each argument. `script`: as typed; `about`: the script's purpose, or empty.
std::string arguments_help(const std::vector<Argument>& known, const std::string& script,
                           const std::string& about);

}  // namespace hw::script
