#include "core/devices/vxm/sequence_commands.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vxm/program_analysis.h"

namespace hw::vxm {
namespace {

bool sets_speed(Op op) { return op >= Op::speed && op <= Op::accel; }

std::vector<std::size_t> begins_of_lines(std::string_view text) {
  std::vector<std::size_t> begins{0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') begins.push_back(i + 1);
  return begins;
}

}  // namespace

Result<CommandText> CommandText::read(std::string_view text) {
  Analysis analysis = analyse_text(text, 0);
  check_programs(analysis);
  for (const Problem& p : analysis.report.problems)
    if (p.error)
      return fail(FaultKind::text, fmt::format("Line {}: {}", p.line + 1, p.sentence),
                  "The blocks are as they were.");
  const std::vector<std::size_t> begins = begins_of_lines(text);
  CommandText out(text);
  std::vector<Stretch> stored;  // in the order of the text
  const auto stretch = [&begins](const Place& p) {
    const std::size_t begin = begins[ix(p.line)] + ix(p.column);
    return Stretch{begin, begin + ix(p.length)};
  };
  for (const auto& [slot, commands] : analysis.programs) {
    if (commands.empty() && slot == 0 && !analysis.has_headings) continue;
    PlacedProgram& program = out.programs[ix(slot)].emplace();
    for (const StoredCommand& s : commands) {
      program.commands.push_back({s.command, stretch(s.place)});
      stored.push_back(program.commands.back().at);
    }
    program.at.end = text.size();
  }
  int slot = 0;
  for (std::size_t line = 0; line < analysis.report.lines.size(); ++line) {
    bool any = false, heading = false;
    for (const Token& token : analysis.report.lines[line].tokens) {
      const Stretch at{begins[line] + ix(token.begin), begins[line] + ix(token.end)};
      const std::string_view word = text.substr(at.begin, at.end - at.begin);
      if (token.kind == TokenKind::comment) {
        if (heading)
          out.programs[ix(slot)]->name = word;
        else
          out.remarks.add(at, any);
        continue;
      }
      any = true;
      const auto same =
          std::find_if(stored.begin(), stored.end(), [&at](const Stretch& s) { return s.covers(at.begin); });
      if (same != stored.end()) continue;
      if (word == "E" || word == "F" || word == "G") continue;  // on-line: the console sees to it
      if (!word.starts_with("PM"))
        return no_block_for(text, at.begin, fmt::format("{} acts at once. Blocks are programs.", word));
      const int next = word.back() - '0';
      if (heading || std::exchange(heading, true)) continue;
      if (out.programs[ix(slot)] && slot != next) out.programs[ix(slot)]->at.end = at.begin;
      slot = next;
      out.programs[ix(slot)]->at = {at.begin, text.size()};
    }
  }
  // A command that a remark follows ends at its last character.
  for (auto& program : out.programs)
    if (program)
      for (PlacedCommand& c : program->commands) {
        std::string_view word = text.substr(c.at.begin, c.at.end - c.at.begin);
        word = word.substr(0, std::min(word.find(';'), word.size()));
        while (word.ends_with(' ')) word.remove_suffix(1);
        c.at.end = c.at.begin + word.size();
      }
  return out;
}

Deeds deeds_of(std::string_view text) {
  const Analysis analysis = analyse_text(text, 0);
  const std::vector<std::size_t> begins = begins_of_lines(text);
  Deeds deeds;
  for (const auto& [slot, commands] : analysis.programs) {
    if (slot > 0) {
      Deed head;
      head.text = fmt::format("PM{}", slot);
      if (!commands.empty()) head.at.begin = head.at.end = begins[ix(commands.front().place.line)];
      deeds.push_back(std::move(head));
    }
    for (const StoredCommand& s : commands) {
      const std::size_t begin = begins[ix(s.place.line)] + ix(s.place.column);
      Deed deed;
      deed.text = listing_of(s.command);
      deed.at = {begin, begin + std::max<std::size_t>(ix(s.place.length), 1)};
      deed.speed = sets_speed(s.command.op);
      deeds.push_back(std::move(deed));
    }
  }
  return deeds;
}

bool may_set_speeds(std::string_view text) {
  const Analysis analysis = analyse_text(text, 0);
  if (analysis.report.has_errors() || analysis.has_headings) return true;
  for (const auto& [slot, commands] : analysis.programs)
    for (const StoredCommand& s : commands) {
      const Op op = s.command.op;
      if (sets_speed(op) || op == Op::call || op == Op::call_pick || op == Op::jump) return true;
    }
  return false;
}

}  // namespace hw::vxm
