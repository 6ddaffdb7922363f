// Questions and their answers, and what the controller says unasked.
#include <algorithm>

#include <fmt/core.h>

#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

constexpr Duration quiet_time = Millis(30);
constexpr Duration longest_gap = Millis(40);  // between the bytes of one message

tl::unexpected<Fault> no_such_answer(std::string_view question, std::string_view reply) {
  return fail(FaultKind::garbled,
              fmt::format("The controller answered {} to {}, which means nothing.", printable(reply),
                          printable(question)),
              "It was asked again.",
              "Look at the cable, the baud rate, and whether another program talks to the controller.");
}

/// What is asked while a stop is under way is no stop by itself.
Transaction own_question(std::string text, ReplyShape shape, Priority priority,
                         std::size_t (*stranger)(std::string_view)) {
  Transaction t(std::move(text), shape, priority);
  t.stranger = stranger;
  t.own_question = priority == Priority::stop;
  return t;
}

}  // namespace

Task<Result<std::string>> VxmDriver::ask(std::string question, ReplyShape shape, Priority priority,
                                         Stranger stranger, Duration patience) {
  Transaction t(std::move(question), shape, priority);
  t.stranger = stranger;
  t.patience = patience;
  co_return co_await ask(std::move(t));
}

Task<Result<std::string>> VxmDriver::ask(Transaction t) {
  // The rest of a message that is coming in would be taken for the answer.
  while (station_ && !unasked_.empty() && scheduler_.now() - heard_at_ < longest_gap) {
    auto paused = co_await station_->pause(Millis(2));
    if (!paused) co_return fail(paused.error());
  }
  if (!station_)
    co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
  asked_ = t.bytes;
  co_return co_await station_->transact(std::move(t));
}

Task<Result<>> VxmDriver::say(std::string text, Priority priority) {
  auto sent = co_await ask(std::move(text), ReplyShape::nothing(), priority, nullptr);
  if (!sent) co_return fail(sent.error());
  co_return Result<>();
}

// A question may be asked once more when its answer was garbled or did not come, and more often while the
// controller is being opened; nothing else is ever repeated.
template <class T>
Task<Result<T>> VxmDriver::ask_decoded(std::string question, ReplyShape shape, Priority priority,
                                       Stranger stranger, std::optional<T> (*decode)(std::string_view)) {
  Result<std::string> reply{std::string()};
  const int attempts = connecting_ ? 4 : 2;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    reply = co_await ask(own_question(question, shape, priority, stranger));
    if (reply) {
      if (auto decoded = decode(*reply)) co_return std::move(*decoded);
    } else if (!worth_another_try(reply.error())) {
      break;
    }
    if (halted_) break;  // it answers nothing until K
    auto quiet = co_await wait_for_quiet();
    if (!quiet) co_return fail(quiet.error());
    if (question.size() == 1 && !connecting_) continue;
    auto ended = co_await say("\r", priority);  // what was left of it would go before the next
    if (!ended) co_return fail(ended.error());
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
  auto reply = co_await ask(own_question(std::string(1, question), ReplyShape::bytes(1), priority, nullptr));
  const bool doubtful = reply && busy() && could_be_message(reply->front());
  Result<> waited;
  if (doubtful && !second_raw_ && station_)
    waited = co_await station_->pause(2 * station_->wire_time(2) + Millis(2));
  raw_asked_ = false;
  if (!reply) co_return fail(reply.error());
  if (!waited) co_return fail(waited.error());
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
Task<Result<>> VxmDriver::wait_for_quiet(Duration at_most) {
  const Instant began = scheduler_.now();
  Instant quiet_at = scheduler_.now() + quiet_time;
  while (station_ && scheduler_.now() < quiet_at && scheduler_.now() - began < at_most) {
    auto paused = co_await station_->pause(quiet_at - scheduler_.now());
    if (!paused) co_return paused;
    quiet_at = std::max(quiet_at, heard_at_ + quiet_time);
  }
  co_return Result<>();
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
    if (m.kind == Message::Kind::unknown && asked_ == "V" && unasked_[taken] == 'V') echoes_ = true;
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
      if (stored_running_) draft_.program.run = RunState::waiting;
      texts_.add("W");
      break;
    case Message::Kind::passed: texts_.add("@"); break;
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
  const bool of_kill = killed_at_ != Instant{} && scheduler_.now() - killed_at_ < Millis(100);
  if (job_.active()) {
    job_.leg_over = true;  // its end is shown once the positions have been read
    if (job_.end_is_asked && !of_kill) texts_.add(std::string(1, prompt));
    return;
  }
  if (stored_running_) run_ended(EndedBy::target);
  if (!of_kill) texts_.add(std::string(1, prompt));
}

// The controller lists the command before which it holds (firmware 1.21 on). Which of several equal commands
// it is follows from the one before.
void VxmDriver::heard_held(std::string_view command) {
  texts_.add(fmt::format(":{}", command));
  if (job_.active()) {
    hold_on_ = release_hold_ = true;  // one that was left on must not keep a move of ours
    return;
  }
  ProgramState& p = draft_.program;
  p.run = RunState::held;
  p.stepping = hold_on_ = true;
  hold_doubtful_ = found_running_ = false;
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
  if (stored_running_) draft_.program.ended_by = EndedBy::limit;
  texts_.add("O");
}

void VxmDriver::heard_error(char letter) {
  const ErrorWords words = explain_error(letter);
  tell(Notice::Kind::error, words.what + " " + words.advice);
  texts_.add(std::string("E") + letter);
  if (letter == error_stopped) {
    if (job_.active()) job_.ended_by = EndedBy::elsewhere;
    if (stored_running_) draft_.program.ended_by = EndedBy::elsewhere;
    draft_.program.command = -1;
    return;
  }
  if (words.halts) {
    halted_ = letter;
    ask_again_at_ = scheduler_.now() + std::chrono::seconds(1);
    draft_.inputs_known = draft_.outputs_known = draft_.analog_known = 0;  // nobody tells them now
    run_ended(EndedBy::error);
    draft_.program.run = RunState::error;
    for (int i = 0; i < draft_.axis_count; ++i) draft_.axes[i].activity = Activity::error;
    show_worst();
  }
  if (letter == error_bus) lose_slave();
  // A restart is found by the next V: it answers J.
}

// Asked about its motors again, the controller would restart each time. The identity, read afresh after the
// restart, tells whether a Slave answers.
void VxmDriver::lose_slave() {
  slave_present_ = false;
  for (int i = motors_per_controller; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    axis.position_known = axis.limits_known = axis.enabled = false;
    axis.activity = Activity::unknown;
  }
}

void VxmDriver::tell(Notice::Kind kind, std::string text) {
  if (notify_) notify_(Notice(kind, scheduler_.now(), std::move(text)));
}
void VxmDriver::tell(const Fault& fault) { tell(Notice::Kind::error, fault.sentence()); }

}  // namespace hw::vxm
