#include "gui/model/command_help.h"

#include <algorithm>

namespace hw::gui {

CommandHelp::CommandHelp(const Catalog& catalog)
    : commands_(catalog.commands), separators_(catalog.command_separators) {
  forms_.reserve(commands_.size());
  for (const CommandInfo& c : commands_) forms_.emplace_back(c, catalog.axes);
}

std::string_view CommandHelp::last_command(std::string_view line) const {
  const auto end = line.find_last_of(separators_);
  return end == line.npos ? line : line.substr(end + 1);
}

std::vector<std::size_t> CommandHelp::candidates(std::string_view line) const {
  const std::string_view text = last_command(line);
  std::vector<std::size_t> whole, begun;
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    const Match m = forms_[i].match(text);
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
    const auto end = std::min(rest.find_first_of(separators_), rest.size());
    for (std::size_t i = 0; i < forms_.size(); ++i)
      if (forms_[i].match(rest.substr(0, end)) == Match::whole) hint.moves |= commands_[i].moves;
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
    hint.sentence = "no command of this controller begins this way; Enter sends it as it is";
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
  return out + forms_[command].head();
}

std::string CommandHelp::complete(std::string_view line) const {
  const std::string_view text = last_command(line);
  std::string shared;
  bool first = true;
  for (const std::size_t i : candidates(line)) {
    const std::string& head = forms_[i].head();
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
