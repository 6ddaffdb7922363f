#include "gui/app/completion.h"

#include <fmt/core.h>

#include "gui/app/cli.h"
#include "gui/app/completed.h"

namespace hw::app {
namespace {

std::string with_escapes(std::string_view text, std::string_view escaped) {
  std::string out;
  for (const char c : text) {
    if (escaped.find(c) != escaped.npos) out += '\\';
    out += c;
  }
  return out;
}

/// In single quotes, for bash and zsh.
std::string in_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}
std::string quoted_for_fish(std::string_view text) { return "'" + with_escapes(text, "\\'") + "'"; }

std::string names_of_commands() {
  std::string names;
  for (const Subcommand* command : subcommands())
    names += (names.empty() ? "" : " ") + std::string(command->name);
  return names;
}

std::string flags_of(std::span<const OptionSpec> options) {
  std::string flags;
  for (const OptionSpec& option : options) flags += fmt::format(" --{}", option.name);
  return flags;
}

// bash

std::string bash_action(const Completed& all) {
  if (all.files) return fmt::format("_handwheel_files {}", in_quotes(all.extension));
  if (all.folders) return "_handwheel_folders";
  return fmt::format("_handwheel_words {}", in_quotes(all.words));
}

void put_bash_values(std::string& script, std::string_view command, std::span<const OptionSpec> options) {
  for (const OptionSpec& option : options) {
    if (!*option.placeholder) continue;
    std::string pattern = in_quotes(fmt::format("{} --{}", command, option.name));
    if (*option.shorter) pattern += "|" + in_quotes(fmt::format("{} -{}", command, option.shorter));
    script += fmt::format("    {}) {}; return ;;\n", pattern, bash_action(completed(option.placeholder)));
  }
}

constexpr std::string_view bash_helpers = R"(# Made by `handwheel reference bash`.

# Readline replaces only what stands behind the last of its word breaks.
_handwheel_behind_break() {
  local head=${current%"${current##*[$COMP_WORDBREAKS]}"}
  COMPREPLY=("${COMPREPLY[@]#"$head"}")
}
_handwheel_words() {
  COMPREPLY=($(compgen -W "$1" -- "$current"))
  _handwheel_behind_break
}
_handwheel_files() {
  local IFS=$'\n' pattern=${1:+"!*.$1"}
  compopt -o filenames 2>/dev/null
  COMPREPLY=($(compgen -f -X "$pattern" -- "$current") $(compgen -d -- "$current"))
}
_handwheel_folders() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY=($(compgen -d -- "$current"))
}

_handwheel() {
  local line=${COMP_LINE:0:COMP_POINT} words word current command='' previous
  current=${line##*[[:space:]]}
  read -ra words <<<"${line%"$current"}"
  previous=${words[-1]}
  for word in "${words[@]:1}"; do
    if [[ " $_handwheel_commands " == *" $word "* ]]; then
      command=$word
      break
    fi
  done
)";

// zsh

std::string zsh_action(std::string_view placeholder) {
  const Completed all = completed(placeholder);
  if (all.files) return all.extension.empty() ? "_files" : fmt::format("_files -g \"*.{}\"", all.extension);
  if (all.folders) return "_files -/";
  return all.words.empty() ? " " : fmt::format("compadd -- {}", all.words);
}

std::string zsh_argument(std::string_view head, std::string_view placeholder) {
  return in_quotes(fmt::format("{}:{}:{}", head, with_escapes(placeholder, ":"),
                               with_escapes(zsh_action(placeholder), ":")));
}

std::string zsh_options(std::span<const OptionSpec> options) {
  std::string all;
  for (const OptionSpec& option : options) {
    const std::string help = fmt::format("[{}]", with_escapes(option.help, "[]:\\"));
    for (const std::string& name : {std::string("--") + option.name, std::string("-") + option.shorter}) {
      if (name == "-") continue;
      const std::string head = (option.repeatable ? "*" : "") + name + help;
      all +=
          " \\\n        " + (*option.placeholder ? zsh_argument(head, option.placeholder) : in_quotes(head));
    }
  }
  return all;
}

std::string zsh_words(const Subcommand& command) {
  std::string all;
  int place = 0;
  for (const WordSpec& word : command.words)
    all += " \\\n        " + zsh_argument(word.maximum == 1 ? fmt::format("{}", ++place) : "*", word.name);
  return all;
}

// fish

std::string fish_action(const Completed& all) {
  if (all.files)
    return all.extension.empty() ? " -r -F"
                                 : fmt::format(" -r -k -a '(__fish_complete_suffix .{})'", all.extension);
  if (all.folders) return " -x -a '(__fish_complete_directories)'";
  return all.words.empty() ? " -x" : fmt::format(" -x -a {}", quoted_for_fish(all.words));
}

void put_fish_options(std::string& script, std::string_view when, std::span<const OptionSpec> options) {
  for (const OptionSpec& option : options) {
    const std::string letter = *option.shorter ? fmt::format(" -s {}", option.shorter) : "";
    script += fmt::format("complete -c handwheel{}{} -l {}{} -d {}\n", when, letter, option.name,
                          *option.placeholder ? fish_action(completed(option.placeholder)) : " -f",
                          quoted_for_fish(option.help));
  }
}

}  // namespace

std::string completion_for_bash() {
  std::string script(bash_helpers);
  script += "  case \"$command $previous\" in\n";
  for (const Subcommand* command : subcommands()) put_bash_values(script, command->name, command->options);
  script +=
      "  esac\n  case $previous in\n    --log) return ;;\n  esac\n  if [[ $current == -* ]]; then\n    case "
      "$command in\n";
  const std::string general = flags_of(general_options());
  for (const Subcommand* command : subcommands())
    script += fmt::format("      {}) _handwheel_words {} ;;\n", command->name,
                          in_quotes("--help" + flags_of(command->options) + general));
  script += fmt::format("      *) _handwheel_words {} ;;\n    esac\n    return\n  fi\n  case $command in\n",
                        in_quotes("--help --version" + general));
  for (const Subcommand* command : subcommands())
    if (!command->words.empty())
      script += fmt::format("    {}) {} ;;\n", command->name, bash_action(completed(command->words[0].name)));
  script += "    '') _handwheel_words \"$_handwheel_commands\" ;;\n  esac\n}\n";
  script += fmt::format("_handwheel_commands={}\ncomplete -F _handwheel handwheel\n",
                        in_quotes(names_of_commands()));
  return script;
}

std::string completion_for_zsh() {
  std::string script =
      "#compdef handwheel\n# Made by `handwheel reference zsh`.\n\n_handwheel() {\n  local state line\n"
      "  local -a commands\n  commands=(\n";
  for (const Subcommand* command : subcommands())
    script += fmt::format(
        "    {}\n", in_quotes(fmt::format("{}:{}", command->name, with_escapes(command->summary, ":"))));
  script += fmt::format(
      "  )\n  _arguments -C '(-)--help[what there is]' '(-)--version[version and commit]'{} \\\n"
      "        '1: :->command' '*:: :->rest'\n",
      zsh_options(general_options()));
  script +=
      "  case $state in\n    command) _describe command commands ;;\n    rest)\n      case $words[1] in\n";
  for (const Subcommand* command : subcommands())
    script += fmt::format("        {}) _arguments '(-)--help[what it takes]'{}{} ;;\n", command->name,
                          zsh_options(command->options), zsh_words(*command));
  return script + "      esac ;;\n  esac\n}\n\n_handwheel \"$@\"\n";
}

std::string completion_for_fish() {
  std::string script = "# Made by `handwheel reference fish`.\n";
  put_fish_options(script, "", general_options());
  script += "complete -c handwheel -l help -f -d 'what there is'\n";
  for (const Subcommand* command : subcommands()) {
    script += fmt::format("complete -c handwheel -n __fish_use_subcommand -f -a {} -d {}\n", command->name,
                          quoted_for_fish(command->summary));
    const std::string when = fmt::format(" -n '__fish_seen_subcommand_from {}'", command->name);
    put_fish_options(script, when, command->options);
    if (!command->words.empty())
      script +=
          fmt::format("complete -c handwheel{}{}\n", when, fish_action(completed(command->words[0].name)));
  }
  return script;
}

}  // namespace hw::app
