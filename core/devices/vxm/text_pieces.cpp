#include "core/devices/vxm/text_pieces.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/reply_kinds.h"

namespace hw::vxm {
namespace {

AnswerShape line_answer() { return {ReplyShape::line(), before_number}; }

std::optional<AnswerShape> answer_shape(const TextCommand& c, const Listening& now);

std::optional<AnswerShape> answer_if_it_has_ended(const TextCommand& c, Listening now) {
  constexpr Duration at_once = Millis(60);
  if (!std::exchange(now.running, false)) return std::nullopt;
  auto answer = answer_shape(c, now);
  if (answer && answer->unsolicited_length == before_prompt)
    return std::nullopt;  // the prompt would be the program's own
  if (answer) answer->perhaps = true, answer->patience = at_once;
  return answer;
}

std::optional<AnswerShape> answer_shape(const TextCommand& c, const Listening& now) {
  if (!now.takes(c)) return answer_if_it_has_ended(c, now);
  if (c.verb == Verb::get || c.verb == Verb::ask_selected || c.verb == Verb::ask_associate)
    return line_answer();
  if (c.verb == Verb::word && c.name == "lst")
    return AnswerShape{ReplyShape::until_quiet(listing_quiet_ms), before_listing};
  if (c.verb == Verb::word && c.name == "rsm")
    return AnswerShape{ReplyShape::bytes(1), before_prompt, store_patience};
  if (c.verb != Verb::letter) return std::nullopt;
  switch (c.letter) {
    case 'D':
      if (!now.local || now.running) return std::nullopt;
      return AnswerShape{ReplyShape::several_lines(static_cast<std::uint16_t>(now.digitized_lines))};
    case 'V': return AnswerShape{ReplyShape::bytes(1), before_state};
    case 'K': return AnswerShape{ReplyShape::bytes(1), before_prompt};
    case 'x':
    case 'y': return AnswerShape{ReplyShape::several_lines(4), before_number};
    case '?':
    case '~':
    case '$': return AnswerShape{ReplyShape::bytes(1)};
    default: break;
  }
  if (std::string_view("XYZTM#*@").find(c.letter) != std::string_view::npos) return line_answer();
  return std::nullopt;
}

/// Inside an open group: ( ) or [ ].
bool within_a_group(std::string_view text) {
  const auto count = [text](char c) { return std::count(text.begin(), text.end(), c); };
  return count('(') != count(')') || count('[') != count(']');
}

// Bytes. A stop waits for the bytes on the wire: long texts are cut after a command.
constexpr std::size_t most_at_once = 24;

bool sets_rate(const TextCommand& c, const Listening& now) {
  return c.verb == Verb::set && c.name == "B" && now.takes(c);
}

/// The state that takes only a few commands, for a sentence.
std::string_view listening_words(const Listening& now) {
  if (now.halted) return "After its error report the controller takes only K, or res";
  if (now.running) return "While a program runs the controller takes only a few letters";
  return "In local mode the controller takes only a few letters";
}

/// Commands that the controller accepts in states that are not known here: T and Z at a standstill, res
/// always.
bool may_be_taken(const TextCommand& c) {
  return c.verb == Verb::letter ? c.letter == 'T' || c.letter == 'Z'
                                : c.verb == Verb::word && c.name == "res";
}

bool is_dropped(const TextCommand& c, const Listening& now) {
  return !now.to_slave && c.flaw == Flaw::none && !now.takes(c) && !may_be_taken(c);
}

}  // namespace

bool Listening::takes(const TextCommand& c) const {
  if (to_slave || c.flaw != Flaw::none) return false;
  const bool is_letter = c.verb == Verb::letter;
  if (halted) return is_letter && c.letter == 'K';
  const std::string_view letters = running ? accepted_while_running : accepted_in_local;
  if (running || local) return is_letter && letters.find(c.letter) != std::string_view::npos;
  return true;
}

void Listening::follow(const TextCommand& c) {
  if (c.verb == Verb::slave_begins) to_slave = true;
  if (c.verb == Verb::slave_ends) to_slave = false;
  if (c.verb == Verb::word && c.name == "res") local = true, running = halted = false;
  if (c.verb != Verb::letter || to_slave) return;
  if (c.letter == 'K') running = halted = false;
  if (running || halted) return;
  if (c.letter == 'E' || c.letter == 'F' || c.letter == 'G') local = false;
  if (c.letter == 'Q') local = true;
  if (c.letter == 'R') running = !local;
}

std::vector<Piece> pieces_of(std::string_view text, const std::vector<TextCommand>& commands, Listening now) {
  std::vector<Piece> pieces;
  std::vector<TextCommand> taken;
  std::size_t from = 0;
  const auto cut_at = [&](std::size_t end, std::optional<AnswerShape> answer) {
    pieces.push_back(
        {std::string(text.substr(from, end - from)), std::move(answer), std::exchange(taken, {})});
    for (const TextCommand& c : pieces.back().taken)
      pieces.back().resets = pieces.back().resets || (c.verb == Verb::word && c.name == "res");
    from = end;
  };
  for (const TextCommand& c : commands) {
    if (now.takes(c) || (!now.to_slave && may_be_taken(c))) taken.push_back(c);
    const bool whole = c.end - from >= most_at_once && !within_a_group(text.substr(0, c.end));
    if (auto answer = answer_shape(c, now)) {
      answer->reply_kind = reply_kind_of(c);
      cut_at(c.end, std::move(answer));
      pieces.back().stores = c.verb == Verb::word && c.name == "rsm";
      pieces.back().kills = c.verb == Verb::letter && c.letter == 'K';
    } else if (sets_rate(c, now)) {
      cut_at(c.end, std::nullopt);
      pieces.back().new_rate = c.value;
    } else if (whole) {
      cut_at(c.end, std::nullopt);
    }
    now.follow(c);
  }
  if (from < text.size()) {
    const bool only_separators = !pieces.empty() && read_text(text.substr(from)).empty();
    cut_at(text.size(), std::nullopt);
    pieces.back().only_separators = only_separators;
  }
  return pieces;
}

const Piece* last_command_of(const std::vector<Piece>& pieces) {
  const auto last =
      std::find_if(pieces.rbegin(), pieces.rend(), [](const Piece& piece) { return !piece.only_separators; });
  return last == pieces.rend() ? nullptr : &*last;
}

std::string dropped_of(const std::vector<TextCommand>& commands, Listening now) {
  std::string dropped;
  std::string_view when;
  for (const TextCommand& c : commands) {
    if (is_dropped(c, now)) {
      if (dropped.empty()) when = listening_words(now);
      dropped += (dropped.empty() ? "" : " ") + canonical(c);
    }
    now.follow(c);
  }
  if (dropped.empty()) return dropped;
  return fmt::format("{} and ignores {} silently.", when, dropped);
}

bool last_is_dropped(const std::vector<TextCommand>& commands, Listening now) {
  bool dropped = false;
  for (const TextCommand& c : commands) {
    dropped = is_dropped(c, now);
    now.follow(c);
  }
  return dropped;
}

}  // namespace hw::vxm
