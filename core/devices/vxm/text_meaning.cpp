#include "core/devices/vxm/text_meaning.h"

#include <algorithm>

namespace hw::vxm {
namespace {

bool is_letter(const TextCommand& c, char letter) { return c.verb == Verb::letter && c.letter == letter; }
bool is_word(const TextCommand& c, std::string_view word) { return c.verb == Verb::word && c.name == word; }

/// The text begins with a stop and starts nothing after it. D at rest ends a motion still on its way to the
/// controller; in Local mode it asks for positions.
TextMeaning::Stops stopped_by(const std::vector<TextCommand>& commands, const Listening& now, bool own_move) {
  using Stops = TextMeaning::Stops;
  const bool starts =
      std::any_of(commands.begin(), commands.end(), [](const TextCommand& c) { return is_letter(c, 'R'); });
  if (commands.empty() || starts) return Stops::nothing;
  const TextCommand& first = commands.front();
  if (is_letter(first, 'K') || is_word(first, "res")) return Stops::all;
  if (!is_letter(first, 'D') || now.local || now.halted) return Stops::nothing;
  return own_move || !now.running ? Stops::all : Stops::some;
}

bool changes_programs(const TextCommand& c) {
  return c.stored() || c.verb == Verb::empty || is_letter(c, 'C') || is_word(c, "del") || is_word(c, "res");
}

/// Whether the command is answered and changes nothing in the controller.
bool asks(const TextCommand& c) {
  if (c.flaw != Flaw::none) return false;
  if (c.verb == Verb::letter)
    return std::string_view("VXYZTxy~?$@#*M").find(c.letter) != std::string_view::npos;
  return c.verb == Verb::get || c.verb == Verb::ask_selected || c.verb == Verb::ask_associate ||
         is_word(c, "lst");
}

}  // namespace

TextMeaning meaning_of(std::string_view text, const Listening& now, bool own_move) {
  const auto commands = read_text(text);
  const auto pieces = pieces_of(text, commands, now);
  const Piece* last = last_command_of(pieces);
  TextMeaning meaning;
  meaning.stops = stopped_by(commands, now, own_move);
  meaning.end_is_reported = !last || !last->answer || last->answer->perhaps;  // by a prompt
  const bool at_rest = !now.running && !commands.empty() && is_letter(commands.back(), 'D');
  if (at_rest && meaning.is_stop()) meaning.end_is_reported = false;
  const bool nothing_comes =
      last_is_dropped(commands, now) || (!commands.empty() && is_word(commands.back(), "res"));
  if (meaning.end_is_reported)
    meaning.answered = nothing_comes ? TextMeaning::Answered::never : TextMeaning::Answered::later;
  meaning.only_asks = !commands.empty() && std::all_of(commands.begin(), commands.end(), asks);
  meaning.changes_programs = std::any_of(commands.begin(), commands.end(), changes_programs);
  meaning.runs_program =
      !now.halted && std::any_of(commands.begin(), commands.end(), [](const TextCommand& c) {
        return is_letter(c, 'R') || is_letter(c, 'G') || is_letter(c, 'H');
      });
  meaning.restarts =
      std::any_of(commands.begin(), commands.end(), [](const TextCommand& c) { return is_word(c, "res"); });
  return meaning;
}

}  // namespace hw::vxm
