#include "panels/path/source_places.h"

#include <algorithm>

#include "core/base/index.h"
#include "gui/model/program_texts.h"

namespace hw::panels {
namespace {

/// The start of each command of the line; empty: commands are not known.
std::vector<int> begins_of_commands(const LineReport& line) {
  std::vector<int> begins;
  int moving = 0;
  for (const Token& token : line.tokens) {
    if (token.kind == TokenKind::comment) continue;
    begins.push_back(token.begin);
    moving += token.kind == TokenKind::moves ? 1 : 0;
  }
  if (moving < 2 || static_cast<int>(begins.size()) != line.command_count) begins.clear();
  return begins;
}

}  // namespace

SourcePlaces source_places(const ProgramReport& report, int slot) {
  SourcePlaces places;
  for (std::size_t line = 0; line < report.lines.size(); ++line) {
    const LineReport& l = report.lines[line];
    if (l.first_command < 0 || l.command_count <= 0 || (l.slot >= 0 && l.slot != slot)) continue;
    const std::size_t end = ix(l.first_command + l.command_count);
    if (places.of_command.size() < end) places.of_command.resize(end, -1);
    const std::vector<int> begins = begins_of_commands(l);
    for (std::size_t c = 0; c < ix(l.command_count); ++c) {
      if (c == 0 || !begins.empty())
        places.all.push_back({static_cast<int>(line), begins.empty() ? 0 : begins[c]});
      places.of_command[ix(l.first_command) + c] = static_cast<int>(places.all.size()) - 1;
    }
  }
  return places;
}

SourcePlaces::IndexRange SourcePlaces::of_line(int line) const {
  const auto first = std::lower_bound(all.begin(), all.end(), line,
                                      [](const SourcePlace& p, int before) { return p.line < before; });
  auto behind = first;
  while (behind != all.end() && behind->line == line) ++behind;
  if (first == behind) return {};
  return {static_cast<int>(first - all.begin()), static_cast<int>(behind - first)};
}

int SourcePlaces::line_of(int source) const {
  return source < 0 || ix(source) >= all.size() ? -1 : all[ix(source)].line;
}

std::string_view SourcePlaces::command_of(int source, std::string_view text) const {
  const SourcePlace& at = all[ix(source)];
  std::string_view line = gui::line_of(text, at.line);
  if (ix(source + 1) < all.size() && all[ix(source + 1)].line == at.line)
    line = line.substr(0, ix(all[ix(source + 1)].byte));
  return line.substr(std::min(line.size(), ix(at.byte)));
}

}  // namespace hw::panels
