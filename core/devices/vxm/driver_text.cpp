// Raw text of the user's or a script's: sent in pieces, and followed, so that the driver knows what it
// changed.
#include <algorithm>

#include <fmt/core.h>

#include "core/devices/vxm/driver.h"
#include "core/devices/vxm/text_pieces.h"

namespace hw::vxm {
namespace {

std::string without_end(std::string reply) {
  if (reply.ends_with('\r')) reply.pop_back();
  return reply;
}

void add_answer(std::string& answers, std::string_view next) {
  if (!answers.empty()) answers += '\r';
  answers += next;
}

/// What stops or asks, or goes on-line: it changes nothing that a move of the console needs to its end.
bool goes_with_a_stop(const TextCommand& c) {
  if (c.verb == Verb::word) return c.name == "res";
  return c.verb == Verb::letter && std::string_view("KDFVXY?~$@").find(c.letter) != std::string_view::npos;
}

Fault not_behind_stop(std::string_view rest) {
  return Fault(
      FaultKind::controller,
      fmt::format("{} was not sent: a move of the console was under way, and its stop was sent first.",
                  printable(rest)),
      "", "Send it again when the move has ended.");
}

/// The answers that came before a failure are not lost.
std::string with_answers(std::string_view answers, std::string_view done) {
  return fmt::format("Before that it answered {}.{}{}", printable(answers), done.empty() ? "" : " ", done);
}

}  // namespace

// What the text changes of which the driver keeps a record.
void VxmDriver::note_taken(const std::vector<TextCommand>& commands) {
  const auto program_changed = [&] {
    if (selected_ < 0) return;
    draft_.slot_bytes_used[static_cast<std::size_t>(selected_)] = -1;
    listings_[static_cast<std::size_t>(selected_)].reset();
    if (confirmed_scratch_ == selected_) confirmed_scratch_ = -1;
    draft_.unsaved_programs = true;
    sizes_read_ = false;
  };
  for (const TextCommand& c : commands) {
    if (c.flaw != Flaw::none) continue;
    if (c.stored()) program_changed();
    if (c.verb == Verb::speed && c.motor >= 1 && c.motor <= max_motors)
      known_speed_[static_cast<std::size_t>(c.motor - 1)] = static_cast<int>(c.value);
    if (c.verb == Verb::select || c.verb == Verb::empty) {
      selected_ = static_cast<int>(c.value);
      if (!stored_running_) draft_.program.slot = static_cast<std::int8_t>(selected_);
      if (c.verb == Verb::empty) program_changed();
    }
    if (c.verb == Verb::set) {
      next_param_ = 0;
      for (std::size_t i = 0; i < catalog_.params.size(); ++i)
        if (catalog_.params[i].mnemonic == c.name) draft_.params[i].known = draft_.params[i].stored = false;
      draft_.unsaved_setup = true;
      if (c.name == "DM" || c.name == "I" || c.name == "D") essentials_read_ = false;
    }
    if (c.verb == Verb::word && c.name == "del") program_changed();
    if (c.verb == Verb::word && c.name == "rsm") all_stored();
    if (c.verb == Verb::word && c.name == "res") {  // the next V finds it restarted
      halted_ = 0;
      end_waits();
    }
    if (c.verb != Verb::letter) continue;
    if (c.letter == 'C') program_changed();
    if (c.letter == 'K') doubt_positions(), killed_at_ = scheduler_.now();
    if (c.letter == 'D' && mode_ == Mode::on_line) note_stop();
    if (c.letter == 'H') hold_on_ = !hold_on_;
    if (c.letter == 'Q') stay_local_ = true, mode_ = Mode::local;
    if (c.letter == 'E' || c.letter == 'F' || c.letter == 'G') stay_local_ = false, mode_ = Mode::on_line;
    if (c.letter == 'G' && draft_.program.run != RunState::idle) draft_.program.run = RunState::running;
    if (c.letter == 'R' && !stored_running_) show_running(selected_);
    if (c.letter == 'N') all_are_zero();
  }
}

void VxmDriver::end_waits() {
  ++stops_said_;
  news_.notify();
}

// The user's own D: nothing of the console's move follows it. Of a stored program it ends one index only.
void VxmDriver::note_stop() {
  if (!job_.active()) return;
  drop_later_legs(-1);
  job_.jog = false;
  if (!job_.leg_over) job_.ended_by = EndedBy::stop;
}

// The controller drops what it does not know without a word.
void VxmDriver::warn_of_flaws(const std::vector<TextCommand>& commands) {
  std::string unknown;
  int unknown_count = 0;
  for (const TextCommand& c : commands)
    if (c.flaw == Flaw::unknown) unknown += (unknown_count++ > 0 ? " " : "") + printable(c.name);
  if (unknown_count == 1)
    tell(Notice::Kind::warning,
         fmt::format("{} is no command of the VXM: the controller drops it without a word. It was sent as it "
                     "is. The terminal lists the commands behind ?.",
                     unknown));
  if (unknown_count > 1)
    tell(
        Notice::Kind::warning,
        fmt::format("{} are no commands of the VXM: the controller drops them without a word. They were sent "
                    "as they are. The terminal lists the commands behind ?.",
                    unknown));
  for (const TextCommand& c : commands) {
    if (c.flaw == Flaw::range)
      tell(Notice::Kind::warning,
           fmt::format(
               "{} is not possible, it takes {}: the controller drops it without a word. It was sent as "
               "it is. Send it again with another number.",
               canonical(c), allowed_values(c)));
    if (c.flaw == Flaw::no_value)
      tell(Notice::Kind::warning,
           fmt::format(
               "{} lacks its number: the controller drops it without a word. It was sent as it is. Send "
               "it again with its number.",
               printable(c.name)));
  }
}

void VxmDriver::warn_of_dropped(const RawAnswer& sent) {
  if (!sent.dropped.empty()) tell(Notice::Kind::warning, sent.dropped + " It was sent as it is.");
}

// Echo would come between every question and its answer: F goes out for E.
static bool without_echo(std::string& text, const std::vector<TextCommand>& commands) {
  bool asked = false;
  for (const TextCommand& c : commands)
    if (c.verb == Verb::letter && c.letter == 'E') asked = true, text[c.begin] = 'F';
  return asked;
}

// Sends it piece by piece and gives back the answers, each without its end, joined by carriage returns.
// `answered`: whether the last piece was one that is answered.
Task<VxmDriver::RawAnswer> VxmDriver::send_pieces(std::string text, Duration patience) {
  const Priority priority = is_stop(text) ? Priority::stop : Priority::intent;
  const auto commands = read_text(text);
  warn_of_flaws(commands);
  if (without_echo(text, commands))
    tell(Notice::Kind::info, "Echo stays off: F was sent for E. The console shows what it sends by itself.");
  Listening now;
  now.local = mode_ == Mode::local, now.running = busy(), now.halted = halted_ != 0;
  now.digitized_lines = slave_present_ ? max_motors : motors_per_controller;
  const auto pieces = pieces_of(text, commands, now);
  bool to_store = std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.stores; });
  const auto failed = [&](Fault why) {
    if (to_store) draft_.unsaved_setup = draft_.unsaved_programs = true;  // rsm is not confirmed
    return why;
  };
  RawAnswer all;
  all.dropped = dropped_of(commands, now);
  const Piece* last = last_command_of(pieces);
  all.last_is_answered = last && last->answer;
  for (const Piece& piece : pieces) {
    note_taken(piece.taken);
    if (!piece.answer) {
      auto sent = co_await say(piece.text, priority);
      if (sent) {
        reset_said_ = reset_said_ || piece.resets;
        continue;
      }
      all.fault = failed(std::move(sent.error()));
      co_return all;
    }
    const Duration wait = std::max(piece.answer->patience, &piece == last ? patience : usual_patience);
    auto reply = co_await ask(piece.text, piece.answer->shape, priority, piece.answer->stranger, wait);
    if (!reply) {
      all.fault = failed(std::move(reply.error()));
      co_return all;
    }
    if (piece.stores) to_store = false;
    if (piece.kills) killed();
    add_answer(all.text, without_end(std::move(*reply)));
  }
  co_return all;
}

Task<Result<>> VxmDriver::send_text(std::string text) {
  if (ends_open(text)) text += '\r';
  const bool stops = is_stop(text);
  const std::string rest = stops ? cut_behind_stop(text) : std::string();
  for (const TextCommand& c : read_text(text)) {
    const bool taken_while_running =
        c.verb == Verb::letter && accepted_while_running.find(c.letter) != std::string_view::npos;
    if (!stops && job_.active() && !taken_while_running && !(c.verb == Verb::word && c.name == "res"))
      co_return fail(
          FaultKind::refused,
          fmt::format("A move of the console is under way, and the controller does not take {} then.",
                      canonical(c)),
          "Nothing was sent.", "Wait until it ends, or stop it.");
  }
  RawAnswer sent = co_await send_pieces(std::move(text), usual_patience);
  warn_of_dropped(sent);
  if (!sent.text.empty()) for_scripts(std::move(sent.text));
  news_.notify();
  if (sent.fault) co_return fail(std::move(*sent.fault));
  if (!rest.empty()) co_return fail(not_behind_stop(rest));
  co_return Result<>();
}

// A move of the console ends in steps that the rest of the text would come between: its program is still
// selected.
std::string VxmDriver::cut_behind_stop(std::string& text) const {
  const auto commands = read_text(text);
  const auto first = std::find_if_not(commands.begin(), commands.end(), goes_with_a_stop);
  if (!job_.active() || first == commands.end()) return {};
  std::string rest = text.substr(first->begin);
  text.resize(first->begin);
  return rest;
}

bool VxmDriver::answers(std::string_view text) const {
  Listening now;
  now.local = mode_ == Mode::local, now.running = busy(), now.halted = halted_ != 0;
  const auto pieces = pieces_of(text, read_text(text), now);
  const Piece* last = last_command_of(pieces);
  return last && last->answer;
}

bool VxmDriver::answers_later(std::string_view text) const { return !answers(text); }

// It begins with what stops, and starts nothing behind that.
bool VxmDriver::is_stop(std::string_view text) const {
  const auto commands = read_text(text);
  if (commands.empty()) return false;
  const TextCommand& first = commands.front();
  const bool ramps = first.letter == 'D' && busy();  // else it asks for places
  const bool stops = first.verb == Verb::letter ? first.letter == 'K' || ramps
                                                : first.verb == Verb::word && first.name == "res";
  return stops && std::none_of(commands.begin(), commands.end(), [](const TextCommand& c) {
           return c.verb == Verb::letter && c.letter == 'R';
         });
}

// D ends one index of a stored program, which goes on.
bool VxmDriver::stops_all(std::string_view text) const {
  if (!is_stop(text)) return false;
  const TextCommand first = read_text(text).front();
  return first.verb == Verb::word || first.letter == 'K' || job_.active();
}

bool VxmDriver::changes_programs(std::string_view text) const {
  const auto commands = read_text(text);
  return std::any_of(commands.begin(), commands.end(), [](const TextCommand& c) {
    return c.stored() || c.verb == Verb::empty || (c.verb == Verb::letter && c.letter == 'C') ||
           (c.verb == Verb::word && (c.name == "del" || c.name == "res"));
  });
}

Task<Result<std::string>> VxmDriver::query(std::string text, Duration patience) {
  auto settled = co_await finish_leg();
  if (!settled) co_return fail(settled.error());
  co_return co_await converse(std::move(text), patience, nullptr);
}

Task<Result<std::string>> VxmDriver::query_stop(std::string text, Duration patience,
                                                std::function<void()> said) {
  ++stop_queries_;
  auto reply = co_await converse(std::move(text), patience, std::move(said));
  --stop_queries_;
  co_return reply;
}

Task<Result<std::string>> VxmDriver::converse(std::string text, Duration patience,
                                              std::function<void()> said) {
  if (ends_open(text)) text += '\r';
  if (read_text(text).empty())
    co_return fail(FaultKind::refused, "There is no command in that text.", "Nothing was sent.");
  const std::string rest = said ? cut_behind_stop(text) : std::string();
  const std::uint64_t asked = next_unasked_;
  RawAnswer sent = co_await send_pieces(std::move(text), patience);
  if (sent.fault || sent.last_is_answered) warn_of_dropped(sent);
  if (sent.fault) {
    auto report = sent.fault->kind == FaultKind::no_answer ? take_since(asked, 'E') : std::nullopt;
    if (!sent.text.empty() && !report) sent.fault->done = with_answers(sent.text, sent.fault->done);
    if (!report) co_return fail(std::move(*sent.fault));
    add_answer(sent.text, *report);  // it came instead of an answer
    co_return std::move(sent.text);
  }
  if (!rest.empty()) {
    Fault cut = not_behind_stop(rest);
    if (!sent.text.empty()) cut.done = with_answers(sent.text, "");
    co_return fail(std::move(cut));
  }
  if (sent.last_is_answered) co_return std::move(sent.text);
  if (said) said();
  auto prompt = co_await wait_for_prompt(asked, patience);
  if (!prompt && sent.text.empty()) {
    if (sent.dropped.empty()) co_return prompt;
    co_return fail(FaultKind::controller, sent.dropped, "It was sent as it is.");
  }
  warn_of_dropped(sent);
  if (prompt) add_answer(sent.text, *prompt);
  co_return std::move(sent.text);
}

// For texts that have no answer of their own: R and what else brings a prompt some time.
Task<Result<std::string>> VxmDriver::wait_for_prompt(std::uint64_t since, Duration patience) {
  const Instant deadline = scheduler_.now() + patience;
  const std::uint64_t stops_before = stops_said_;
  for (bool in_time = true;;) {
    if (stops_said_ != stops_before)
      co_return fail(FaultKind::stopped, "A stop has ended what the answer was waited for.", "It was sent.");
    if (auto text = take_since(since)) co_return std::move(*text);
    if (prompts_until_ > since) co_return std::string(1, prompt);  // somebody else who waits has taken it
    if (!station_) co_return fail(FaultKind::lost, "The connection was lost before an answer came.");
    if (!in_time)
      co_return fail(FaultKind::no_answer, fmt::format("No answer came in {:g} s.", seconds(patience)));
    in_time = co_await news_.wait_until(deadline);
  }
}

}  // namespace hw::vxm
