#include "gui/command_help.h"

#include <algorithm>
#include <cctype>

namespace hw::gui {

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

CommandHelp::CommandHelp(const std::vector<CommandInfo>& commands) : commands_(commands) {
  forms_.reserve(commands.size());
  for (const CommandInfo& c : commands) forms_.push_back(form_of(c));
}

// A letter of the form is a place for a number where the example has digits instead of it; so the m of "rsm"
// stays a letter and the m of "SmMx" does not.
CommandHelp::Form CommandHelp::form_of(const CommandInfo& command) {
  Form form;
  std::size_t e = 0;
  const std::string& example = command.example;
  for (std::size_t i = 0; i < command.form.size(); ++i) {
    const char c = command.form[i];
    const bool same = e < example.size() && example[e] == c;
    if (!same && e < example.size() && is_digit(example[e])) {
      const bool letter_follows = i + 1 < command.form.size() && !is_digit(command.form[i + 1]);
      const bool one = letter_follows && (e + 1 >= example.size() || !is_digit(example[e + 1]));
      form.parts.push_back({0, one});
      do ++e;
      while (!one && e < example.size() && is_digit(example[e]));
      continue;
    }
    form.parts.push_back({c, false});
    if (same) ++e;
  }
  for (const Part& p : form.parts) {
    if (p.literal == 0) break;
    form.head += p.literal;
  }
  return form;
}

CommandHelp::Match CommandHelp::match(const Form& form, std::string_view text) {
  std::size_t t = 0;
  for (const Part& part : form.parts) {
    if (t == text.size()) return Match::begins;
    if (part.literal != 0) {
      if (text[t] != part.literal) return Match::none;
      ++t;
      continue;
    }
    if (!is_digit(text[t])) return Match::none;
    do ++t;
    while (!part.one_digit && t < text.size() && is_digit(text[t]));
  }
  return t == text.size() ? Match::whole : Match::none;
}

std::string_view CommandHelp::last_command(std::string_view line) {
  const auto end = line.find_last_of(",. ");
  return end == line.npos ? line : line.substr(end + 1);
}

std::vector<std::size_t> CommandHelp::candidates(std::string_view line) const {
  const std::string_view text = last_command(line);
  std::vector<std::size_t> whole, begun;
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    const Match m = match(forms_[i], text);
    if (m == Match::whole) whole.push_back(i);
    if (m == Match::begins) begun.push_back(i);
  }
  std::stable_sort(begun.begin(), begun.end(), [&](std::size_t a, std::size_t b) {
    return commands_[a].form.size() < commands_[b].form.size();
  });
  whole.insert(whole.end(), begun.begin(), begun.end());
  return whole;
}

CommandHelp::Hint CommandHelp::hint(std::string_view line) const {
  Hint hint;
  if (line.empty()) return hint;
  for (std::string_view rest = line; !rest.empty();) {
    const auto end = std::min(rest.find_first_of(",. "), rest.size());
    for (std::size_t i = 0; i < forms_.size(); ++i)
      if (match(forms_[i], rest.substr(0, end)) == Match::whole) hint.moves |= commands_[i].moves;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  const std::string_view last = last_command(line);
  if (last.empty()) {
    hint.sentence = hint.moves ? "Enter may move something now" : "";
    return hint;
  }
  const auto found = candidates(line);
  if (found.empty()) {
    hint.unknown = true;
    hint.sentence = "no command of this controller begins so; Enter sends it as it is";
    return hint;
  }
  const CommandInfo& best = commands_[found.front()];
  hint.sentence = best.help;
  if (best.stored && !hint.moves) hint.sentence += ". Stored in the program, moves nothing now";
  if (hint.moves) hint.sentence += ". Enter moves something now";
  return hint;
}

std::string CommandHelp::with(std::string_view line, std::size_t command) const {
  const std::string_view text = last_command(line);
  std::string out(line.substr(0, line.size() - text.size()));
  return out + forms_[command].head;
}

std::string CommandHelp::complete(std::string_view line) const {
  const std::string_view text = last_command(line);
  std::string shared;
  bool first = true;
  for (const std::size_t i : candidates(line)) {
    const std::string& head = forms_[i].head;
    if (head.size() < text.size() || head.substr(0, text.size()) != text) return std::string(line);
    if (first) {
      shared = head;
      first = false;
      continue;
    }
    std::size_t n = 0;
    while (n < shared.size() && n < head.size() && shared[n] == head[n]) ++n;
    shared.resize(n);
  }
  if (shared.size() <= text.size()) return std::string(line);
  return std::string(line.substr(0, line.size() - text.size())) + shared;
}

}  // namespace hw::gui
