#include "core/devices/vxm/conversation.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/driver_faults.h"
#include "core/devices/vxm/reply_kinds.h"

namespace hw::vxm {
namespace {

constexpr Duration quiet_time = Millis(30), longest_noise = Millis(500);
constexpr Duration longest_gap = Millis(40);  // between the bytes of one message
constexpr Duration greeting_patience = Millis(300);
constexpr Duration late_greeting_patience = std::chrono::seconds(3);

tl::unexpected<Fault> no_such_answer(std::string_view question, std::string_view reply) {
  return fail(FaultKind::garbled,
              fmt::format("The controller answered {} to {}, which is not a valid reply.", printable(reply),
                          printable(question)),
              "It was asked again.", check_line);
}

using Unsolicited = std::size_t (*)(std::string_view);

/// A question asked during a stop is not itself a stop.
Transaction own_question(std::string text, ReplyShape shape, Priority priority,
                         Unsolicited unsolicited_length, ReplyKind reply_kind) {
  Transaction t(std::move(text), shape, priority);
  t.unsolicited_length = unsolicited_length;
  t.reply_kind = reply_kind;
  t.own_question = priority == Priority::stop;
  return t;
}

}  // namespace

Conversation::Conversation(Scheduler& scheduler, std::function<Listening()> listening,
                           std::function<void(const Message&)> on_unsolicited)
    : scheduler_(scheduler), listening_(std::move(listening)), on_unsolicited_(std::move(on_unsolicited)) {}

void Conversation::attach(Station& station) {
  station_ = &station;
  echoes_ = false;
  prompt_greetings_ = 0;
  station.unsolicited = [this](std::string_view bytes) { return receive_unsolicited(bytes); };
  station.unmistakable = [this](const OutstandingReplies& outstanding, Instant now) {
    return unmistakable(outstanding, now, listening_(), echoes_);
  };
}

void Conversation::lost() {
  station_ = nullptr;
  unsolicited_.clear();
  raw_asked_ = false;
}

// ---- questions

Task<Result<std::string>> Conversation::exchange(Transaction t) {
  // The rest of an incoming message would be taken for the reply.
  while (station_ && !unsolicited_.empty() && scheduler_.now() - received_at_ < longest_gap) {
    auto paused = co_await station_->pause(Millis(2));
    if (!paused) co_return fail(paused.error());
  }
  if (!station_) co_return not_connected("controller");
  asked_ = t.bytes;
  auto reply = co_await station_->transact(std::move(t));
  if (reply && station_) asked_at_ = scheduler_.now() - station_->statistics().last_round_trip;
  co_return reply;
}

// A question is repeated once when its reply was garbled or missing, more often while the controller is being
// opened; nothing else is ever repeated. Outstanding replies are handled in between.
template <class T>
Task<Result<T>> Conversation::decoded(Transaction question,
                                      std::function<std::optional<T>(std::string_view)> decode) {
  Result<std::string> reply{std::string()};
  const int attempts = patient_ ? 4 : 2;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const bool was_dirty = station_ && station_->is_dirty();
    reply = co_await exchange(question);
    if (reply) {
      if (auto decoded = decode(*reply)) co_return std::move(*decoded);
      if (station_) station_->doubt(question.reply_kind);
    } else if (!worth_another_try(reply.error())) {
      break;
    }
    ++repeats_;
    const bool is_lost = !reply && was_dirty && !patient_;
    if (is_lost || listening_().halted) break;  // a halted controller answers nothing until K
    auto quiet = co_await wait_for_quiet();
    if (!quiet) co_return fail(quiet.error());
    if (question.bytes.size() == 1 && !patient_) continue;
    auto ended = co_await transmit_anyway("\r");  // a fragment of the question would precede the next one
    if (!ended) co_return fail(ended.error());
  }
  if (!reply) co_return fail(reply.error());
  co_return no_such_answer(question.bytes, *reply);
}

Task<Result<char>> Conversation::state(Priority priority) {
  auto t = own_question("V", ReplyShape::bytes(1), priority, before_state, reply_kind::letter);
  co_return co_await decoded<char>(std::move(t), decode_state);
}

Task<Result<Steps>> Conversation::position(int motor, Priority priority) {
  auto t =
      own_question(ask_position(motor), ReplyShape::line(), priority, before_number, reply_kind::position);
  co_return co_await decoded<Steps>(std::move(t), decode_position);
}

Task<Result<std::int64_t>> Conversation::number(std::string question, Priority priority) {
  auto t = own_question(std::move(question), ReplyShape::line(), priority, before_number, reply_kind::number);
  co_return co_await decoded<std::int64_t>(std::move(t), decode_number);
}

Task<Result<>> Conversation::confirm(std::string text, std::int64_t number, Priority priority) {
  auto t = own_question(std::move(text), ReplyShape::line(), priority, before_number, reply_kind::number);
  const auto decode = [number](std::string_view reply) {
    const auto decoded_number = decode_number(reply);
    return decoded_number == number ? decoded_number : std::nullopt;
  };
  auto decoded_number = co_await decoded<std::int64_t>(std::move(t), decode);
  if (!decoded_number) co_return fail(decoded_number.error());
  co_return Result<>();
}

Task<Result<std::string>> Conversation::text(std::string question, Priority priority) {
  auto t = own_question(std::move(question), ReplyShape::line(), priority, before_number, reply_kind::text);
  co_return co_await decoded<std::string>(std::move(t), decode_text_line);
}

Task<Result<Listing>> Conversation::listing(Priority priority) {
  auto t =
      own_question("lst", ReplyShape::until_quiet(listing_quiet_ms), priority, nullptr, reply_kind::lines);
  co_return co_await decoded<Listing>(std::move(t), decode_listing);
}

Task<Result<Listing>> Conversation::listing_of(std::size_t commands, Priority priority) {
  const auto lines = ReplyShape::several_lines(static_cast<std::uint16_t>(commands + 1));
  auto t = own_question("lst", lines, priority, before_listing, reply_kind::lines);
  co_return co_await decoded<Listing>(std::move(t), decode_listing);
}

// The byte may have any value, even that of a prompt. If so, and a second byte follows at once, the byte that
// is a message is the prompt.
Task<Result<unsigned char>> Conversation::raw(char question, Priority priority) {
  raw_asked_ = true;
  second_raw_.reset();
  auto t = own_question(std::string(1, question), ReplyShape::bytes(1), priority, nullptr, reply_kind::raw);
  auto reply = co_await exchange(std::move(t));
  const bool doubtful = reply && listening_().running && could_be_message(reply->front());
  Result<> waited;
  if (doubtful && !second_raw_ && station_)
    waited = co_await station_->pause(2 * station_->wire_time(2) + Millis(2));
  raw_asked_ = false;
  if (!reply) co_return fail(reply.error());
  if (!waited) co_return fail(waited.error());
  char answer = reply->front();
  if (second_raw_ && doubtful) std::swap(answer, *second_raw_);
  if (const auto second = std::exchange(second_raw_, std::nullopt)) {
    const char other = *second;
    receive_unsolicited(std::string_view(&other, 1));
  }
  co_return static_cast<unsigned char>(answer);
}

Task<Result<std::string>> Conversation::places(ReplyShape shape, Priority priority) {
  auto t = own_question("D", shape, priority, nullptr, reply_kind::position);
  t.on_dirty_line = true;
  co_return co_await exchange(std::move(t));
}

// A reply may be an outstanding one that comes late. Two replies that each come at once, with silence after
// them, are not outstanding ones, which were not requested one right after the other.
Task<Result<std::string>> Conversation::greet(std::uint16_t quiet_ms) {
  auto t =
      own_question("V", ReplyShape::until_quiet(quiet_ms), Priority::intent, nullptr, reply_kind::letter);
  t.patience = station_ && station_->is_dirty() ? late_greeting_patience : greeting_patience;
  t.on_dirty_line = true;
  const Instant asked_at = scheduler_.now();
  auto reply = co_await exchange(std::move(t));
  if (!station_) co_return reply;
  constexpr Duration at_once = Millis(60);
  const bool is_prompt = reply && reply->size() == 1 &&
                         scheduler_.now() - asked_at < Millis(quiet_ms) + at_once + station_->wire_time(4);
  prompt_greetings_ = is_prompt ? prompt_greetings_ + 1 : 0;
  if (prompt_greetings_ >= 2) station_->has_caught_up();
  co_return reply;
}

Task<Result<std::string>> Conversation::ask_while_silent() {
  auto t = own_question("V", ReplyShape::bytes(1), Priority::poll, before_state, reply_kind::letter);
  t.may_be_silent = true;
  co_return co_await exchange(std::move(t));
}

Task<Result<std::string>> Conversation::ask(std::string question, AnswerShape answer, Priority priority) {
  Transaction t(std::move(question), answer.shape, priority);
  t.unsolicited_length = answer.unsolicited_length;
  t.patience = answer.patience;
  t.reply_kind = answer.reply_kind;
  t.may_be_silent = answer.perhaps;
  co_return co_await exchange(std::move(t));
}

Task<Result<std::string>> Conversation::kill(Priority priority, Duration patience) {
  const AnswerShape prompt{ReplyShape::bytes(1), before_prompt, patience, reply_kind::prompt};
  co_return co_await ask("K", prompt, priority);
}

// ---- commands without a reply

Task<Result<>> Conversation::transmit(std::string text, Priority priority) {
  auto sent = co_await exchange(Transaction(std::move(text), ReplyShape::nothing(), priority));
  if (!sent) co_return fail(sent.error());
  co_return Result<>();
}

Task<Result<>> Conversation::transmit_anyway(std::string text) {
  Transaction t(std::move(text), ReplyShape::nothing(), Priority::intent);
  t.on_dirty_line = true;
  auto sent = co_await exchange(std::move(t));
  if (!sent) co_return fail(sent.error());
  co_return Result<>();
}

Task<Result<>> Conversation::wait_for_quiet() {
  const Instant began = scheduler_.now();
  Instant quiet_at = scheduler_.now() + quiet_time;
  while (station_ && scheduler_.now() < quiet_at && scheduler_.now() - began < longest_noise) {
    auto paused = co_await station_->pause(quiet_at - scheduler_.now());
    if (!paused) co_return paused;
    quiet_at = std::max(quiet_at, received_at_ + quiet_time);
  }
  co_return Result<>();
}

// ---- unsolicited messages

std::size_t Conversation::receive_unsolicited(std::string_view bytes) {
  if (scheduler_.now() - received_at_ > longest_gap) unsolicited_.clear();
  received_at_ = scheduler_.now();
  if (raw_asked_ && !second_raw_ && unsolicited_.empty()) {
    second_raw_ = bytes.front();
    return 1 + (bytes.size() > 1 ? receive_unsolicited(bytes.substr(1)) : 0);
  }
  const std::size_t kept = unsolicited_.size();
  unsolicited_ += bytes;
  std::size_t taken = 0;
  std::optional<std::size_t> first_unknown;
  while (taken < unsolicited_.size()) {
    const Message m = next_message(std::string_view(unsolicited_).substr(taken));
    if (m.kind == Message::Kind::unfinished) break;
    const bool unknown = m.kind == Message::Kind::unknown || !believes(m);
    if (unknown) ++unexpected_;
    if (unknown && !first_unknown) first_unknown = taken;
    if (unknown && asked_ == "V" && unsolicited_[taken] == 'V') echoes_ = true;
    taken += m.length;
    if (!unknown) on_unsolicited_(m);
  }
  unsolicited_.erase(0, taken);
  if (!first_unknown) return bytes.size();
  return *first_unknown > kept ? *first_unknown - kept : 0;
}

// False: the byte may be an outstanding reply. A raw byte may look like a one-byte message, and a listing
// like many messages.
bool Conversation::believes(const Message& m) const {
  if (!station_ || !station_->is_dirty()) return true;
  const OutstandingReplies& outstanding = station_->outstanding();
  if (outstanding.may_be_outstanding(reply_kind::lines, scheduler_.now())) return false;
  return m.length > 1 || !outstanding.may_be_outstanding(reply_kind::raw, scheduler_.now());
}

}  // namespace hw::vxm
