#pragma once
// What a script takes behind its name: how that is read, and told. Pure.
//   PLACE          by its place, where there is no default
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
  std::string fallback;  ///< as it would be given; empty: none
  std::string help;
  std::vector<std::string> choices;  ///< empty: any
};

struct GivenArguments {
  bool wants_help = false;
  std::map<std::string, std::string> values;  ///< by name; a flag: empty
};

/// "number"; nothing: there is no such kind.
Result<Argument::Kind> argument_kind(const std::string& word);
/// A fault says in one sentence which word is wrong, and what was to stand there.
Result<GivenArguments> read_arguments(const std::vector<Argument>& known,
                                      const std::vector<std::string>& words);
/// How the script is called, and a line for each. `script`: as it was given; `about`: what it does, or empty.
std::string arguments_help(const std::vector<Argument>& known, const std::string& script,
                           const std::string& about);

}  // namespace hw::script
