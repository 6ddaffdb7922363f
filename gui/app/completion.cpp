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

/// Puts a text in single quotes, for bash and zsh.
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

/// Options that take a value, as they are written: " --output -o".
std::string valued_flags(std::span<const OptionSpec> options) {
  std::string flags;
  for (const OptionSpec& option : options) {
    if (!*option.placeholder) continue;
    flags += fmt::format(" --{}", option.name);
    if (*option.shorter) flags += fmt::format(" -{}", option.shorter);
  }
  return flags;
}

std::string flags_of(std::span<const OptionSpec> options) {
  std::string flags;
  for (const OptionSpec& option : options) flags += fmt::format(" --{}", option.name);
  return flags;
}

// bash

std::string bash_action(const Completed& all) {
  if (all.ports) return "_handwheel_ports";
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

void put_bash_general_values(std::string& script) {
  for (const OptionSpec& option : general_options())
    if (*option.placeholder)
      script +=
          fmt::format("    --{}) {}; return ;;\n", option.name, bash_action(completed(option.placeholder)));
}

/// A word that may be repeated is the last.
void put_bash_words(std::string& script, const Subcommand& command) {
  for (std::size_t place = 0; place < command.words.size(); ++place) {
    const WordSpec& word = command.words[place];
    const std::string where =
        word.maximum == 1 ? fmt::format("'{} {}'", command.name, place) : fmt::format("'{} '*", command.name);
    script += fmt::format("    {}) {} ;;\n", where, bash_action(completed(word.name)));
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
_handwheel_ports() {
  _handwheel_files ''
  [[ $current ]] || COMPREPLY+=($(compgen -G '/dev/tty[A-Z]*'))
}
_handwheel_folders() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY=($(compgen -d -- "$current"))
}

_handwheel() {
  local line=${COMP_LINE:0:COMP_POINT} words word current command='' previous before='' place=0
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

// Counts the words after the subcommand that are neither options nor values of options.
constexpr std::string_view bash_place = R"(  local behind=''
  for word in "${words[@]:1}"; do
    if [[ ! $behind ]]; then
      [[ $word == "$command" ]] && behind=yes
    elif [[ $word != -* && " $valued " != *" $before "* ]]; then
      place=$((place + 1))
    fi
    before=$word
  done
)";

// zsh

std::string zsh_action(std::string_view placeholder) {
  const Completed all = completed(placeholder);
  if (all.ports) return "{ compadd -- /dev/tty[A-Z]*(N); _files }";
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

/// Counts the words after the subcommand that are neither options nor values of options.
constexpr std::string_view fish_helpers = R"(# Made by `handwheel reference fish`.
function __handwheel_place -a command first last
    set -l valued $argv[4..-1]
    set -l words (commandline -opc)
    set -l place -1
    set -l before ''
    for word in $words[2..-1]
        if test $place -lt 0
            test "$word" = $command; and set place 0
        else if not string match -q -- '-*' $word; and not contains -- "$before" $valued
            set place (math $place + 1)
        end
        set before $word
    end
    test $place -ge $first -a $place -le $last
end
)";

std::string fish_action(const Completed& all) {
  if (all.ports) return " -r -F -a '(string match -r \"^/dev/tty[A-Z].*\" /dev/tty*)'";
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

void put_fish_words(std::string& script, const Subcommand& command) {
  const std::string valued = valued_flags(command.options) + valued_flags(general_options());
  for (std::size_t place = 0; place < command.words.size(); ++place) {
    const WordSpec& word = command.words[place];
    const std::string last = word.maximum == 1 ? fmt::format("{}", place) : "999";
    script += fmt::format("complete -c handwheel -n '__handwheel_place {} {} {}{}'{}\n", command.name, place,
                          last, valued, fish_action(completed(word.name)));
  }
  // Behind the last word there is nothing more.
  if (command.words.empty() || command.words.back().maximum == 1)
    script += fmt::format("complete -c handwheel -n '__handwheel_place {} {} 999{}' -f\n", command.name,
                          command.words.size(), valued);
}

}  // namespace

std::string completion_for_bash() {
  std::string script(bash_helpers);
  script += "  case \"$command $previous\" in\n";
  for (const Subcommand* command : subcommands()) put_bash_values(script, command->name, command->options);
  script += "  esac\n  case $previous in\n";
  put_bash_general_values(script);
  script += "  esac\n  if [[ $current == -* ]]; then\n    case $command in\n";
  const std::string general = flags_of(general_options());
  for (const Subcommand* command : subcommands())
    script += fmt::format("      {}) _handwheel_words {} ;;\n", command->name,
                          in_quotes("--help" + flags_of(command->options) + general));
  script += fmt::format("      *) _handwheel_words {} ;;\n    esac\n    return\n  fi\n",
                        in_quotes("--help --version" + general));
  script +=
      "  local valued\n  case $command in\n    '') _handwheel_words \"$_handwheel_commands\"; return ;;\n";
  for (const Subcommand* command : subcommands())
    script += fmt::format("    {}) valued={} ;;\n", command->name,
                          in_quotes(valued_flags(command->options) + valued_flags(general_options())));
  script += fmt::format("  esac\n{}  case \"$command $place\" in\n", bash_place);
  for (const Subcommand* command : subcommands()) put_bash_words(script, *command);
  script += "  esac\n}\n";
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
    script +=
        fmt::format("        {}) _arguments '(-)--help[what it takes]'{}{} ;;\n", command->name,
                    zsh_options(command->options) + zsh_options(general_options()), zsh_words(*command));
  return script + "      esac ;;\n  esac\n}\n\n_handwheel \"$@\"\n";
}

std::string completion_for_fish() {
  std::string script(fish_helpers);
  put_fish_options(script, "", general_options());
  script +=
      "complete -c handwheel -l help -f -d 'what there is'\n"
      "complete -c handwheel -n __fish_use_subcommand -l version -f -d 'version and commit'\n";
  for (const Subcommand* command : subcommands()) {
    script += fmt::format("complete -c handwheel -n __fish_use_subcommand -f -a {} -d {}\n", command->name,
                          quoted_for_fish(command->summary));
    const std::string when = fmt::format(" -n '__fish_seen_subcommand_from {}'", command->name);
    put_fish_options(script, when, command->options);
    put_fish_words(script, *command);
  }
  return script;
}

}  // namespace hw::app
