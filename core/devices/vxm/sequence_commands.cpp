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

/// Finds the places of commands and headings in a text.
class Placer {
 public:
  Placer(std::string_view text, const Analysis& analysis, CommandText& out)
      : text_(text), analysis_(analysis), begins_(begins_of_lines(text)), out_(out) {}

  void place_commands() {
    for (const auto& [slot, commands] : analysis_.programs) {
      if (commands.empty() && slot == 0 && !analysis_.has_headings) continue;
      PlacedProgram& program = out_.programs[ix(slot)].emplace();
      for (const StoredCommand& s : commands) {
        program.commands.push_back({s.command, stretch(s.place)});
        stored_.push_back(program.commands.back().at);
      }
      program.at.end = text_.size();
    }
  }
  /// Reads the rest: headings, remarks, and text that no block can hold.
  Result<> read_lines() {
    for (std::size_t line = 0; line < analysis_.report.lines.size(); ++line) {
      any_ = heading_ = false;
      for (const Token& token : analysis_.report.lines[line].tokens) {
        const Stretch at{begins_[line] + ix(token.begin), begins_[line] + ix(token.end)};
        if (token.kind == TokenKind::comment)
          remark(at);
        else if (auto read = word(at); !read)
          return read;
      }
    }
    return {};
  }
  /// A command that a remark follows ends at its last character.
  void end_commands() {
    for (auto& program : out_.programs) {
      if (!program) continue;
      for (PlacedCommand& c : program->commands) {
        std::string_view word = text_.substr(c.at.begin, c.at.end - c.at.begin);
        word = word.substr(0, std::min(word.find(';'), word.size()));
        while (word.ends_with(' ')) word.remove_suffix(1);
        c.at.end = c.at.begin + word.size();
      }
    }
  }

 private:
  [[nodiscard]] Stretch stretch(const Place& p) const {
    const std::size_t begin = begins_[ix(p.line)] + ix(p.column);
    return {begin, begin + ix(p.length)};
  }
  void remark(const Stretch& at) {
    if (heading_)
      out_.programs[ix(slot_)]->name = text_.substr(at.begin, at.end - at.begin);
    else
      out_.remarks.add(at, any_);
  }
  Result<> word(const Stretch& at) {
    any_ = true;
    const bool is_stored =
        std::any_of(stored_.begin(), stored_.end(), [&at](const Stretch& s) { return s.covers(at.begin); });
    const std::string_view done = text_.substr(at.begin, at.end - at.begin);
    if (is_stored || done == "E" || done == "F" || done == "G")
      return {};  // on-line: the console does this itself
    if (!done.starts_with("PM"))
      return no_block_for(text_, at.begin, fmt::format("{} acts at once. Blocks are programs.", done));
    if (!std::exchange(heading_, true)) begin_program(done.back() - '0', at.begin);
    return {};
  }
  void begin_program(int next, std::size_t begin) {
    if (out_.programs[ix(slot_)] && slot_ != next) out_.programs[ix(slot_)]->at.end = begin;
    slot_ = next;
    out_.programs[ix(slot_)]->at = {begin, text_.size()};
  }

  std::string_view text_;
  const Analysis& analysis_;
  const std::vector<std::size_t> begins_;
  CommandText& out_;
  std::vector<Stretch> stored_;  ///< in the order of the text
  int slot_ = 0;
  bool any_ = false, heading_ = false;  ///< of the current line, so far
};

}  // namespace

Result<CommandText> CommandText::read(std::string_view text) {
  Analysis analysis = analyse_text(text, 0);
  check_programs(analysis);
  for (const Problem& p : analysis.report.problems)
    if (p.error)
      return fail(FaultKind::text, fmt::format("Line {}: {}", p.line + 1, p.sentence), blocks_unchanged);
  CommandText out(text);
  Placer placer(text, analysis, out);
  placer.place_commands();
  if (auto read = placer.read_lines(); !read) return fail(read.error());
  placer.end_commands();
  return out;
}

Operations operations_of(std::string_view text) {
  const Analysis analysis = analyse_text(text, 0);
  const std::vector<std::size_t> begins = begins_of_lines(text);
  Operations operations;
  for (const auto& [slot, commands] : analysis.programs) {
    if (slot > 0) {
      Operation head;
      head.text = fmt::format("PM{}", slot);
      if (!commands.empty()) head.at.begin = head.at.end = begins[ix(commands.front().place.line)];
      operations.push_back(std::move(head));
    }
    for (const StoredCommand& s : commands) {
      const std::size_t begin = begins[ix(s.place.line)] + ix(s.place.column);
      Operation operation;
      operation.text = listing_of(s.command);
      operation.at = {begin, begin + std::max<std::size_t>(ix(s.place.length), 1)};
      operation.speed = sets_speed(s.command.op);
      operations.push_back(std::move(operation));
    }
  }
  return operations;
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
