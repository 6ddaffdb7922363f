#include "core/devices/vxm/texts.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/reply_kinds.h"

namespace hw::vxm {
namespace {

constexpr Duration longest_confirmation = Millis(500);

std::string without_end(std::string reply) {
  if (reply.ends_with('\r')) reply.pop_back();
  return reply;
}

void add_answer(std::string& answers, std::string_view next) {
  if (!answers.empty()) answers += '\r';
  answers += next;
}

/// Stops, asks, or goes on-line: changes nothing that a move of the console needs to its end.
bool allowed_beside_stop(const TextCommand& c) {
  if (c.verb == Verb::word) return c.name == "res";
  return c.verb == Verb::letter && std::string_view("KDFVXY?~$@").find(c.letter) != std::string_view::npos;
}

Fault not_behind_stop(std::string_view rest) {
  return Fault(
      FaultKind::refused,
      fmt::format("{} was not sent: a move from the console was under way, and its stop was sent first.",
                  printable(rest)),
      "", "Send it again when the move has ended.");
}

/// Keeps the replies received before a failure.
std::string with_answers(std::string_view answers, std::string_view done) {
  return fmt::format("Before that it answered {}.{}{}", printable(answers), done.empty() ? "" : " ", done);
}

}  // namespace

// ---- recorded changes

void Texts::note_taken(const Piece& piece) {
  for (const TextCommand& c : piece.taken)
    if (c.flaw == Flaw::none) note_taken(c);
  if (piece.resets) presence_.note_reset_sent();
}

void Texts::note_taken(const TextCommand& c) {
  if (c.stored()) slots_.selected_was_changed(c);
  speeds_.note(c);
  if (c.verb == Verb::select || c.verb == Verb::empty) {
    slots_.was_selected(static_cast<int>(c.value));
    if (c.verb == Verb::empty) slots_.selected_was_changed(c);
  }
  if (c.verb == Verb::set) parameters_.was_set(c.name);
  if (c.verb == Verb::word && c.name == "del") slots_.selected_was_changed(c);
  if (c.verb == Verb::word && c.name == "rsm") parameters_.was_stored();
  if (c.verb == Verb::word && c.name == "res")
    presence_.note_answers_again();  // the next V finds it restarted
  if (c.verb == Verb::letter && c.letter == 'C') slots_.selected_was_changed(c);
  if (c.verb == Verb::letter) note_letter(c.letter);
}

void Texts::note_letter(char letter) {
  switch (letter) {
    case 'K':
      kills_.doubt_positions();
      under_way_.kill_was_sent();
      break;
    case 'D':
      if (!presence_.is_local()) under_way_.job().note_stop();
      break;
    case 'H':
      hold_.was_toggled();
      if (console_.snapshot.program.run == RunState::held) console_.snapshot.program.run = RunState::running;
      break;
    case 'Q': presence_.was_sent_to_local(); break;
    case 'E':
    case 'F':
    case 'G':
      presence_.was_sent_on_line();
      if (letter == 'G' && console_.snapshot.program.run != RunState::idle)
        console_.snapshot.program.run = RunState::running;
      break;
    case 'R':
      if (!under_way_.program_runs()) under_way_.program_begins(slots_.selected());
      break;
    case 'N': positions_.are_zero(); break;
    default: break;
  }
}

// ---- warnings

// The controller drops unknown commands silently.
void Texts::warn_of_flaws(const std::vector<TextCommand>& commands) const {
  std::string unknown;
  int unknown_count = 0;
  for (const TextCommand& c : commands)
    if (c.flaw == Flaw::unknown) unknown += (unknown_count++ > 0 ? " " : "") + printable(c.name);
  if (unknown_count == 1)
    console_.report(Notice::Kind::warning,
                    fmt::format("{} is not a command of the VXM, and the controller ignores it silently. It "
                                "was sent as typed. Type ? in the terminal to list the commands.",
                                unknown));
  if (unknown_count > 1)
    console_.report(Notice::Kind::warning,
                    fmt::format("{} are not commands of the VXM, and the controller ignores them silently. "
                                "They were sent as typed. Type ? in the terminal to list the commands.",
                                unknown));
  for (const TextCommand& c : commands) {
    if (c.flaw == Flaw::range)
      console_.report(Notice::Kind::warning,
                      fmt::format("Send {0} again with another number: it takes {1}. {0} was sent as typed, "
                                  "and the controller ignores it silently.",
                                  canonical(c), allowed_values(c)));
    if (c.flaw == Flaw::no_value)
      console_.report(Notice::Kind::warning, fmt::format("Send {0} again with its number: {0} was sent as "
                                                         "typed, and the controller ignores it silently.",
                                                         printable(c.name)));
  }
}

// ---- sending

// Replaces E by F: an echo would come between every question and its reply.
static bool without_echo(std::string& text, const std::vector<TextCommand>& commands) {
  bool asked = false;
  for (const TextCommand& c : commands)
    if (c.verb == Verb::letter && c.letter == 'E') asked = true, text[c.begin] = 'F';
  return asked;
}

// Sends the text piece by piece. Returns the replies, each without its end, joined by carriage returns.
Task<Texts::RawAnswer> Texts::send_pieces(std::string text, Duration patience, Priority priority) {
  const auto commands = read_text(text);
  warn_of_flaws(commands);
  if (without_echo(text, commands))
    console_.report(
        Notice::Kind::info,
        "Echo stays off: F was sent instead of E. The console itself shows each command that it sends.");
  const Listening now = conversation_.listens();
  const auto pieces = pieces_of(text, commands, now);
  RawAnswer all;
  all.dropped = dropped_of(commands, now);
  all.last_is_dropped = last_is_dropped(commands, now);
  const Piece* last = last_command_of(pieces);
  for (const Piece& piece : pieces) {
    Result<std::string> reply;
    std::optional<Station::Uncut> uncut;  // a stop in between would be sent at a rate that is not received
    if (piece.new_rate > 0 && conversation_.station()) uncut.emplace(*conversation_.station());
    if (piece.answer) {
      AnswerShape answer = *piece.answer;
      const Duration wanted = &piece == last ? patience : usual_patience;
      const bool is_stop = priority == Priority::stop;  // sent again when not confirmed
      if (!answer.perhaps)
        answer.patience =
            std::max(answer.patience, is_stop ? std::min(wanted, longest_confirmation) : wanted);
      reply = co_await conversation_.ask(piece.text, answer, priority);
      if (reply && answer.perhaps) all.dropped.clear();
    } else {
      reply = co_await conversation_.ask(piece.text, {ReplyShape::nothing()}, priority);
    }
    const bool was_sent = reply || reply.error().kind != FaultKind::stopped;
    if (was_sent) note_taken(piece);
    const bool may_be_silent = piece.answer && piece.answer->perhaps;
    if (!reply && may_be_silent && reply.error().kind == FaultKind::no_answer) continue;
    if (!reply) {
      if (was_sent && piece.kills) under_way_.kill_not_confirmed(EndedBy::abort);
      if (was_sent && piece.stores)
        console_.snapshot.unsaved_setup = console_.snapshot.unsaved_programs = true;
      all.fault = std::move(reply.error());
      co_return all;
    }
    if (piece.kills) under_way_.killed();
    if (piece.answer) add_answer(all.text, without_end(std::move(*reply)));
    if (piece.new_rate == 0) continue;
    if (auto followed = co_await parameters_.follow_rate(piece.new_rate); !followed) {
      all.fault = std::move(followed.error());
      co_return all;
    }
  }
  co_return all;
}

// Refuses commands that the controller would drop silently during a move of the console, whose program is
// selected.
Result<> Texts::may_send(const std::vector<TextCommand>& commands) const {
  for (const TextCommand& c : commands) {
    const bool taken_while_running =
        c.verb == Verb::letter && accepted_while_running.find(c.letter) != std::string_view::npos;
    if (under_way_.job().active() && !taken_while_running && !(c.verb == Verb::word && c.name == "res"))
      return fail(
          FaultKind::refused,
          fmt::format(
              "A move from the console is under way, and the controller does not accept {} during it.",
              canonical(c)),
          "Nothing was sent.", "Wait until the move ends, or stop it.");
  }
  return {};
}

Task<Result<>> Texts::send(std::string text) {
  if (ends_open(text)) text += '\r';
  if (auto may = may_send(read_text(text)); !may) co_return may;
  RawAnswer sent = co_await send_pieces(std::move(text), usual_patience, Priority::intent);
  if (!sent.dropped.empty()) console_.report(Notice::Kind::warning, sent.dropped + " It was sent as typed.");
  if (!sent.text.empty()) console_.texts.add(std::move(sent.text));
  if (sent.fault) co_return fail(std::move(*sent.fault));
  co_return Result<>();
}

Task<Result<std::string>> Texts::converse(std::string text, Duration patience, Priority priority) {
  if (ends_open(text)) text += '\r';
  if (read_text(text).empty())
    co_return fail(FaultKind::refused, "There is no command in that text.", "Nothing was sent.");
  const std::uint64_t asked = console_.texts.next();
  RawAnswer sent = co_await send_pieces(std::move(text), patience, priority);
  if (!sent.fault && sent.last_is_dropped && sent.text.empty())
    co_return fail(FaultKind::controller, sent.dropped, "It was sent as typed.");
  if (!sent.dropped.empty()) console_.report(Notice::Kind::warning, sent.dropped + " It was sent as typed.");
  if (!sent.fault) co_return std::move(sent.text);
  auto report =
      sent.fault->kind == FaultKind::no_answer ? console_.texts.take_since(asked, 'E') : std::nullopt;
  if (!report && !sent.text.empty()) sent.fault->done = with_answers(sent.text, sent.fault->done);
  if (!report) co_return fail(std::move(*sent.fault));
  add_answer(sent.text, *report);  // an error report came instead of an answer
  co_return std::move(sent.text);
}

Task<Result<std::string>> Texts::stop_by_words(const StopOrder& order) {
  std::string text = order.words;
  const std::string rest = cut_behind_stop(text);
  const auto commands = read_text(text);
  const bool kills = !commands.empty() && commands.front().letter == 'K';
  if (!commands.empty() && commands.front().letter == 'D') {
    under_way_.job().note_stop();
    if (under_way_.job().active()) ramp_.expect();
  }
  under_way_.job().ask_for_end(order.answer != nullptr);
  const bool blind = presence_.is_unknown();
  auto reply = co_await converse(text, order.patience, Priority::stop);
  if (!reply && reply.error().kind == FaultKind::no_answer && blind && kills) {  // Local mode drops it
    // F removes the only sign of a restart.
    const AnswerShape state{ReplyShape::bytes(1), before_state, kill_patience, reply_kind::letter};
    auto was = co_await conversation_.ask("VF", state, Priority::stop);
    if (!was && was.error().kind != FaultKind::no_answer) co_return fail(was.error());
    const bool was_local = was && (was->front() == jog_idle || was->front() == jog_moving);
    using Left = Presence::LeftLocal;
    presence_.left_local(!was ? Left::perhaps : was_local ? Left::yes : Left::no);
    reply = co_await converse(std::move(text), order.patience, Priority::stop);
  }
  if (!reply && reply.error().kind == FaultKind::no_answer && blind)
    co_return fail(FaultKind::no_answer,
                   fmt::format("{} was sent, but nothing answered.", printable(order.words)), "",
                   "Check that the controller is switched on, the cable, and the baud rate.");
  if (!reply) co_return reply;
  if (!rest.empty()) {
    Fault cut = not_behind_stop(rest);
    if (!reply->empty()) cut.done = with_answers(*reply, "");
    co_return fail(std::move(cut));
  }
  if (!order.answer && !reply->empty()) console_.texts.add(*reply);
  co_return reply;
}

// The rest of the text would come between the final steps of a move of the console: its program is still
// selected.
std::string Texts::cut_behind_stop(std::string& text) const {
  const auto commands = read_text(text);
  const auto first = std::find_if_not(commands.begin(), commands.end(), allowed_beside_stop);
  if (!under_way_.job().active() || first == commands.end()) return {};
  std::string rest = text.substr(first->begin);
  text.resize(first->begin);
  return rest;
}

}  // namespace hw::vxm
