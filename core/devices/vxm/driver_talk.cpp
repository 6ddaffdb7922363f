// Questions and their answers, raw text, and what the controller says unasked.
#include <fmt/format.h>

#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

constexpr std::size_t most_for_scripts = 256;
constexpr std::uint16_t listing_quiet_ms = 60;  // a USB adapter may hold bytes back for 16 ms
constexpr Duration quiet_time = Millis(30);
constexpr Duration longest_gap = Millis(40);  // between the bytes of one message

std::string printable(std::string_view bytes) {
  std::string all;
  for (const char c : bytes)
    all += c >= ' ' && c < 127 ? std::string(1, c)
           : c == '\r'         ? "<cr>"
                               : fmt::format("<{:02X}>", static_cast<unsigned char>(c));
  return all;
}

tl::unexpected<Fault> no_such_answer(std::string_view question, std::string_view reply) {
  return fail(FaultKind::garbled,
              fmt::format("The controller answered {} to {}, which means nothing.", printable(reply),
                          printable(question)),
              "It was asked twice.",
              "Look at the cable, the baud rate, and whether another program talks to the controller.");
}

}  // namespace

Task<Result<std::string>> VxmDriver::ask(std::string question, ReplyShape shape, Priority priority,
                                         Stranger stranger, Duration patience) {
  // The rest of a message that is coming in would be taken for the answer.
  while (station_ && !unasked_.empty() && scheduler_.now() - heard_at_ < longest_gap)
    co_await scheduler_.sleep_for(Millis(2));
  if (!station_)
    co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
  Transaction t(std::move(question), shape, priority);
  t.stranger = stranger;
  t.patience = patience;
  co_return co_await station_->transact(std::move(t));
}

Task<Result<>> VxmDriver::say(std::string text, Priority priority) {
  auto sent = co_await ask(std::move(text), ReplyShape::nothing(), priority, nullptr);
  if (!sent) co_return fail(sent.error());
  co_return Result<>();
}

// A question may be asked once more when its answer was garbled or did not come; nothing else is ever
// repeated.
template <class T>
Task<Result<T>> VxmDriver::ask_decoded(std::string question, ReplyShape shape, Priority priority,
                                       Stranger stranger, std::optional<T> (*decode)(std::string_view)) {
  Result<std::string> reply{std::string()};
  for (int attempt = 0; attempt < 2; ++attempt) {
    reply = co_await ask(question, shape, priority, stranger);
    if (reply) {
      if (auto decoded = decode(*reply)) co_return std::move(*decoded);
    } else if (reply.error().kind != FaultKind::no_answer && reply.error().kind != FaultKind::garbled) {
      break;
    }
    if (halted_) break;  // it answers nothing until K
    co_await wait_for_quiet();
  }
  if (!reply) co_return fail(reply.error());
  co_return no_such_answer(question, *reply);
}

Task<Result<char>> VxmDriver::ask_state(Priority priority) {
  co_return co_await ask_decoded("V", ReplyShape::bytes(1), priority, before_state, decode_state);
}
Task<Result<Steps>> VxmDriver::ask_position(int motor, Priority priority) {
  std::string question = vxm::ask_position(motor);
  co_return co_await ask_decoded(std::move(question), ReplyShape::line(), priority, before_number,
                                 decode_position);
}
Task<Result<std::int64_t>> VxmDriver::ask_number(std::string question, Priority priority) {
  co_return co_await ask_decoded(std::move(question), ReplyShape::line(), priority, before_number,
                                 decode_number);
}
Task<Result<std::string>> VxmDriver::ask_text(std::string question, Priority priority) {
  co_return co_await ask_decoded(std::move(question), ReplyShape::line(), priority, before_number,
                                 decode_text_line);
}
Task<Result<Listing>> VxmDriver::ask_listing(Priority priority) {
  co_return co_await ask_decoded("lst", ReplyShape::until_quiet(listing_quiet_ms), priority, nullptr,
                                 decode_listing);
}

// One raw byte can be any value, also that of a prompt. When it could be one and a second byte follows at
// once, the two are told apart: the prompt is the one that is a message.
Task<Result<unsigned char>> VxmDriver::ask_raw(char question, Priority priority) {
  raw_asked_ = true;
  second_raw_.reset();
  auto reply = co_await ask(std::string(1, question), ReplyShape::bytes(1), priority, nullptr);
  const bool doubtful = reply && busy() && could_be_message(reply->front());
  if (doubtful && !second_raw_)
    co_await scheduler_.sleep_for(station_ ? 2 * station_->wire_time(2) + Millis(2) : Duration());
  raw_asked_ = false;
  if (!reply) co_return fail(reply.error());
  char answer = reply->front();
  if (second_raw_ && doubtful) {
    std::swap(answer, *second_raw_);
    const char first = *second_raw_;
    hear(std::string_view(&first, 1));
  } else if (second_raw_) {
    const char second = *second_raw_;
    hear(std::string_view(&second, 1));
  }
  co_return static_cast<unsigned char>(answer);
}

// After an answer that made no sense: whatever still comes must not be taken for the next one, and nothing
// may be sent while the controller sends (the overrun of the manual's p.30 locks it until power-off).
Task<> VxmDriver::wait_for_quiet() {
  Instant quiet_at = scheduler_.now() + quiet_time;
  while (station_ && scheduler_.now() < quiet_at) {
    co_await scheduler_.sleep_until(quiet_at);
    quiet_at = std::max(quiet_at, heard_at_ + quiet_time);
  }
}

// ---- what comes unasked

std::size_t VxmDriver::hear(std::string_view bytes) {
  if (scheduler_.now() - heard_at_ > longest_gap) unasked_.clear();
  heard_at_ = scheduler_.now();
  if (raw_asked_ && !second_raw_ && unasked_.empty()) {
    second_raw_ = bytes.front();
    return 1 + (bytes.size() > 1 ? hear(bytes.substr(1)) : 0);
  }
  const std::size_t kept = unasked_.size();
  unasked_ += bytes;
  std::size_t taken = 0;
  std::optional<std::size_t> first_unknown;
  while (taken < unasked_.size()) {
    const Message m = next_message(std::string_view(unasked_).substr(taken));
    if (m.kind == Message::Kind::unfinished) break;
    if (m.kind == Message::Kind::unknown && !first_unknown) first_unknown = taken;
    taken += m.length;
    heard(m);
  }
  unasked_.erase(0, taken);
  if (!first_unknown) return bytes.size();
  return *first_unknown > kept ? *first_unknown - kept : 0;
}

void VxmDriver::heard(const Message& m) {
  switch (m.kind) {
    case Message::Kind::prompt: heard_prompt(); break;
    case Message::Kind::limit: heard_limit(); break;
    case Message::Kind::waits:
      draft_.program.run = RunState::waiting;
      for_scripts("W");
      break;
    case Message::Kind::passed: for_scripts("@"); break;
    case Message::Kind::held: heard_held(m.text); break;
    case Message::Kind::error: heard_error(m.letter); break;
    case Message::Kind::end:
    case Message::Kind::unknown:
    case Message::Kind::unfinished: return;
  }
  news_.notify();
  if (changed_) changed_();
}

void VxmDriver::heard_prompt() {
  if (job_.active()) {
    job_.leg_over = true;  // its end is shown once the positions have been read
    return;
  }
  const bool of_kill = killed_at_ != Instant{} && scheduler_.now() - killed_at_ < Millis(100);
  if (stored_running_) run_ended(EndedBy::target);
  if (!of_kill) for_scripts("^");
}

// The controller lists the command before which it holds (firmware 1.21 on). Which of several equal commands
// it is follows from the one before.
void VxmDriver::heard_held(std::string_view command) {
  for_scripts(fmt::format(":{}", command));
  if (job_.active()) {
    release_hold_ = true;  // a hold that was left on must not keep a move of ours
    return;
  }
  ProgramState& p = draft_.program;
  p.run = RunState::held;
  p.stepping = true;
  p.command_told = false;
  const int before = p.command;
  p.command = -1;
  if (p.slot < 0 || p.slot >= program_count || !listings_[static_cast<std::size_t>(p.slot)]) return;
  const auto& listing = *listings_[static_cast<std::size_t>(p.slot)];
  int matches = 0, first = -1, next = -1;
  for (int i = 0; i < static_cast<int>(listing.size()); ++i) {
    if (listing[static_cast<std::size_t>(i)] != command) continue;
    ++matches;
    if (first < 0) first = i;
    if (next < 0 && i > before) next = i;
  }
  p.command = static_cast<std::int16_t>(next >= 0 ? next : first);
  p.command_told = matches == 1;
}

void VxmDriver::heard_limit() {
  if (job_.active())
    job_.limit_reported = true;
  else
    tell(Notice::Kind::warning, "A limit switch was hit. The controller has stopped that motor.");
  for_scripts("O");
}

void VxmDriver::heard_error(char letter) {
  const ErrorWords words = explain_error(letter);
  tell(Notice::Kind::error, words.what + " " + words.advice);
  for_scripts(std::string("E") + letter);
  if (letter == error_stopped) {
    if (job_.active())
      job_.ended_by = EndedBy::stop;
    else
      draft_.program.command = -1;
    return;
  }
  if (words.halts) {
    halted_ = letter;
    run_ended(EndedBy::error);
    draft_.program.run = RunState::error;
    for (int i = 0; i < draft_.axis_count; ++i) draft_.axes[i].activity = Activity::error;
    show_worst();
  }
  // A restart is found by the next V: it answers J.
}

void VxmDriver::for_scripts(std::string text) {
  if (for_scripts_.size() >= most_for_scripts) for_scripts_.pop_front();
  for_scripts_.push_back(std::move(text));
}

bool VxmDriver::take_unsolicited(std::string& text) {
  if (for_scripts_.empty()) return false;
  text = std::move(for_scripts_.front());
  for_scripts_.pop_front();
  return true;
}

void VxmDriver::tell(Notice::Kind kind, std::string text) {
  if (notify_) notify_(Notice(kind, scheduler_.now(), std::move(text)));
}
void VxmDriver::tell(const Fault& fault) { tell(Notice::Kind::error, fault.sentence()); }

// ---- raw text

// What the text changes of which the driver keeps a record.
void VxmDriver::note_sent(const std::vector<TextCommand>& commands) {
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
    if (c.verb == Verb::word && c.name == "res") halted_ = 0;  // the next V finds it restarted
    if (c.verb != Verb::letter) continue;
    if (c.letter == 'C') program_changed();
    if (c.letter == 'K') doubt_positions(), killed();
    if (c.letter == 'H') hold_on_ = !hold_on_;
    if (c.letter == 'Q') stay_local_ = true, mode_ = Mode::local;
    if (c.letter == 'E' || c.letter == 'F' || c.letter == 'G') stay_local_ = false, mode_ = Mode::on_line;
    if (c.letter == 'G' && draft_.program.run != RunState::idle) draft_.program.run = RunState::running;
    if (c.letter == 'R' && !stored_running_) show_running(selected_);
    if (c.letter == 'N')
      for (int i = 0; i < draft_.axis_count; ++i) draft_.axes[i].position_doubtful = false;
  }
}

// The controller drops what it does not know without a word.
void VxmDriver::warn_of_flaws(const std::vector<TextCommand>& commands) {
  for (const TextCommand& c : commands) {
    if (c.flaw == Flaw::unknown)
      tell(Notice::Kind::warning,
           fmt::format(
               "{} is no command of the VXM: the controller drops it without a word. It was sent as it "
               "is. Press ? for the list of commands.",
               printable(c.name)));
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

Task<Result<>> VxmDriver::send_text(std::string text) {
  if (ends_open(text)) text += '\r';
  const auto commands = read_text(text);
  for (const TextCommand& c : commands) {
    const bool taken_while_running =
        c.verb == Verb::letter && accepted_while_running.find(c.letter) != std::string_view::npos;
    if (job_.active() && !taken_while_running && !(c.verb == Verb::word && c.name == "res"))
      co_return fail(
          FaultKind::refused,
          fmt::format("A move of the console is under way, and the controller does not take {} then.",
                      canonical(c)),
          "Nothing was sent.", "Wait until it ends, or stop it.");
  }
  warn_of_flaws(commands);
  bool echo = false;
  for (const TextCommand& c : commands)
    echo = c.verb == Verb::letter ? c.letter == 'E' || (echo && c.letter != 'F') : echo;
  if (echo) {
    text += 'F';
    tell(Notice::Kind::info, "Echo was switched off again: the console shows what it sends by itself.");
  }
  note_sent(commands);
  co_return co_await say(std::move(text), Priority::intent);
}

namespace {
/// How the answer to the last command of a text ends.
struct AnswerShape {
  ReplyShape shape;
  std::size_t (*stranger)(std::string_view) = nullptr;
};
std::optional<AnswerShape> answer_shape(const TextCommand& c, int motors, bool local) {
  AnswerShape a;
  if (c.verb == Verb::get || c.verb == Verb::ask_selected || c.verb == Verb::ask_associate)
    return a.shape = ReplyShape::line(), a.stranger = before_number, a;
  if (c.verb == Verb::word && c.name == "lst") return a.shape = ReplyShape::until_quiet(listing_quiet_ms), a;
  if (c.verb == Verb::word && c.name == "rsm")
    return a.shape = ReplyShape::bytes(1), a.stranger = before_prompt, a;
  if (c.verb != Verb::letter) return std::nullopt;
  if (c.letter == 'D' && local) return a.shape = ReplyShape::several_lines(motors > 2 ? 4 : 2), a;
  if (c.letter == 'V') return a.shape = ReplyShape::bytes(1), a.stranger = before_state, a;
  if (c.letter == 'K') return a.shape = ReplyShape::bytes(1), a.stranger = before_prompt, a;
  if (c.letter == 'x' || c.letter == 'y')
    return a.shape = ReplyShape::several_lines(4), a.stranger = before_number, a;
  if (std::string_view("?~$").find(c.letter) != std::string_view::npos)
    return a.shape = ReplyShape::bytes(1), a;
  if (std::string_view("XYZTM#*@").find(c.letter) != std::string_view::npos)
    return a.shape = ReplyShape::line(), a.stranger = before_number, a;
  return std::nullopt;
}
}  // namespace

bool VxmDriver::answers(std::string_view text) const {
  const auto commands = read_text(text);
  return !commands.empty() &&
         answer_shape(commands.back(), static_cast<int>(catalog_.axes.size()), mode_ == Mode::local)
             .has_value();
}

Task<Result<std::string>> VxmDriver::query(std::string text, Duration patience) {
  auto settled = co_await finish_leg();
  if (!settled) co_return fail(settled.error());
  if (ends_open(text)) text += '\r';
  const auto commands = read_text(text);
  if (commands.empty())
    co_return fail(FaultKind::refused, "There is no command in that text.", "Nothing was sent.");
  const TextCommand& last = commands.back();
  const auto shape = answer_shape(last, static_cast<int>(catalog_.axes.size()), mode_ == Mode::local);
  if (!shape) {
    auto sent = co_await send_text(std::move(text));
    if (!sent) co_return fail(sent.error());
    co_return co_await wait_for_prompt(patience);
  }
  note_sent(commands);
  auto reply = co_await ask(std::move(text), shape->shape, Priority::intent, shape->stranger, patience);
  if (!reply) co_return fail(reply.error());
  if (last.verb == Verb::letter && last.letter == 'K')
    run_ended(EndedBy::abort), halted_ = 0, hold_on_ = false;
  if (reply->ends_with('\r')) reply->pop_back();
  co_return std::move(*reply);
}

// For texts that have no answer of their own: R and what else brings a prompt some time.
Task<Result<std::string>> VxmDriver::wait_for_prompt(Duration patience) {
  const Instant deadline = scheduler_.now() + patience;
  std::string text;
  for (;;) {
    if (take_unsolicited(text)) co_return std::move(text);
    if (!station_) co_return fail(FaultKind::lost, "The connection was lost before an answer came.");
    const bool in_time = co_await news_.wait_until(deadline);
    if (!in_time && for_scripts_.empty())
      co_return fail(FaultKind::no_answer, fmt::format("No answer came in {:g} s.", seconds(patience)));
  }
}

}  // namespace hw::vxm
