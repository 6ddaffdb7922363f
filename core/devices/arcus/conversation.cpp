#include "core/devices/arcus/conversation.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/device/driver_faults.h"

namespace hw::arcus {
namespace {

constexpr Duration usual_patience = Millis(200);
struct Quiet {
  Duration time, longest_noise;
};
constexpr Quiet usual_quiet{Millis(30), Millis(300)};
constexpr Quiet quiet_of_slow_line{Millis(45), Millis(800)};  // bytes come up to 40 ms apart

tl::unexpected<Fault> reply_not_understood(std::string_view question, std::string_view reply) {
  return fail(FaultKind::garbled,
              fmt::format("The controller answered {} to {}, which is not a valid reply.",
                          reply.empty() ? "with an empty text" : printable(reply), question),
              "It was asked twice.",
              "Check the cable and the baud rate. Check whether two devices have the same address, or "
              "another program uses this line.");
}

}  // namespace

std::string printable(std::string_view bytes) {
  std::string all;
  for (const char c : bytes.substr(0, 40))
    all += c >= ' ' && c < 127 ? std::string(1, c) : fmt::format("<{:02X}>", static_cast<unsigned char>(c));
  return all;
}

void Conversation::attach(Station& station) {
  station_ = &station;
  station.unsolicited = [this](std::string_view bytes) { return receive_unsolicited(bytes); };
  station.unmistakable = [this](const OutstandingReplies& outstanding, Instant now) {
    return unmistakable(outstanding, now);
  };
}

Framing Conversation::framing() const {
  return station_ && station_->carries_messages() ? Framing::message : Framing::addressed;
}

// An unanswered text may have lost its end and would swallow the next one, so it is ended first. So may a
// text sent before the wire was opened, and a stop is not repeated like a question.
std::string Conversation::framed(std::string_view text, Priority priority, int address) const {
  std::string bytes = frame(framing(), address, text);
  if (framing() == Framing::message || !station_) return bytes;
  const bool first_of_all = priority == Priority::stop && !station_->has_received();
  if (first_of_all || station_->is_dirty() || station_->others_outstanding()) bytes.insert(0, cut_off);
  return bytes;
}

// ---- one text and its reply

// A stop waits for nothing, and its reply is not confirmed by a name.
Task<Result<Reply>> Conversation::exchange(std::string text, Priority priority, Duration patience,
                                           bool own_question) {
  const bool must_be_sure = own_question || priority != Priority::stop;
  if (must_be_sure && !own_question) {
    auto clean = co_await may_go_out(text, priority);
    if (!clean) co_return fail(clean.error());
  }
  if (!station_) co_return no_connection();
  const bool anothers = address_of(text) >= 0 && address_of(text) != console_.catalog.address;
  const std::string command = anothers ? std::string() : command_in(text);
  const ReplyKind reply_kind = own_question ? reply_kinds::of_question(console_.forms, text)
                                            : reply_kinds::of_text(console_.forms, command);
  if (command.starts_with("DN=")) also_called_ = number_in_name(console_.model(), command.substr(3));
  if (goes_out) goes_out(command);
  const int received_before = texts_received_;
  auto reply = co_await transmit(text, priority, patience, own_question, false);
  if (not_done && (reply ? reply->refused() : was_kept_back(reply.error()))) not_done(command);
  if (!reply || !must_be_sure || !others_may_reply(reply_kind)) co_return reply;
  auto named = co_await receive_its_name(priority);
  if (!named) co_return fail(named.error());
  if (texts_received_ == received_before) co_return reply;
  co_return fail(
      FaultKind::garbled,
      fmt::format("{} was answered twice: one of the replies is late and belongs to an earlier query.", text),
      "Neither reply was used.");
}

Task<bool> Conversation::clean_line(Priority priority) {
  if (!station_) co_return false;
  auto clean = co_await station_->clean_line(priority);
  co_return clean.has_value();
}

// For a command that may move or change something, it must be certain whether it was sent.
Task<Result<>> Conversation::may_go_out(std::string_view text, Priority priority) {
  if (!station_) co_return no_connection();
  const std::string kept(text);
  auto clean = co_await station_->clean_line(priority);
  if (clean || !worth_another_try(clean.error())) co_return clean;
  co_return fail(FaultKind::refused, "The controller does not answer, not even a query for its name.",
                 fmt::format("{} was not sent.", kept));
}

Task<Result<Reply>> Conversation::transmit(std::string text, Priority priority, Duration patience,
                                           bool own_question, bool on_dirty_line) {
  if (!station_) co_return no_connection();
  const bool usb = station_->carries_messages();
  Transaction t(framed(text, priority, console_.catalog.address),
                usb ? ReplyShape::message() : ReplyShape::text(), priority);
  t.patience = patience;
  t.impatient = priority == Priority::stop && !own_question && patience <= until_next_of_stop;
  t.prompt = own_question;
  t.own_question = own_question && priority != Priority::transfer;
  t.on_dirty_line = on_dirty_line;
  t.reply_kind = own_question ? reply_kinds::of_question(console_.forms, text)
                              : reply_kinds::of_text(console_.forms, command_in(text));
  if (t.reply_kind == reply_kinds::name && station_->others_outstanding(reply_kinds::name))
    t.unsolicited_length = [this](std::string_view received) {
      return reply_kinds::others_at_front(received,
                                          [this](std::string_view name) { return is_its_name(name); });
    };
  else if (!usb)
    t.unsolicited_length = [this, names = t.reply_kind != reply_kinds::name,
                            its_own = text.ends_with(cut_off.front())](std::string_view received) {
      const std::size_t refusal = its_own ? 0 : refusal_of_cut_at_front(received);
      if (refusal != 0) return refusal;
      return names ? unsolicited_or_name_at_front(console_.model(), received)
                   : unsolicited_at_front(received);
    };
  auto bytes = co_await station_->transact(std::move(t));
  if (!bytes) co_return fail(bytes.error());
  if (station_) asked_at_ = console_.scheduler.now() - station_->statistics().last_round_trip;
  if (!usb && bytes->starts_with('\n')) ++line_feeds_;  // it followed the previous reply
  Reply reply = decode_reply(*bytes);
  const int asked = std::max(address_of(text), console_.catalog.address);
  if (reply.id && address_of(text) < 0 && *reply.id != asked)
    co_return fail(
        FaultKind::garbled,
        fmt::format("Device {:02} was asked {}, and device {:02} answered.", asked, text, *reply.id),
        "Its reply was not used.",
        "Close any other program that uses this line. A late reply is possible too.");
  co_return reply;
}

Task<Result<Reply>> Conversation::greet(Duration patience) {
  co_return co_await transmit("DN", Priority::intent, patience, true, true);
}

// ---- whose reply it is

bool Conversation::others_may_reply(ReplyKind reply_kind) const {
  if (!station_) return false;
  return reply_kind == reply_kinds::text
             ? station_->others_outstanding()
             : station_->others_outstanding(reply_kind) || station_->others_outstanding(reply_kinds::text);
}

// Any text before its name is a late reply, whoever sent it, and is left to receive_unsolicited().
Task<Result<>> Conversation::receive_its_name(Priority priority) {
  if (!station_) co_return no_connection();
  Transaction t =
      identity_question("DN", [this](std::string_view text) { return is_its_name(text); }).question;
  t.priority = priority;
  t.patience = usual_patience;
  t.own_question = priority != Priority::transfer;
  auto bytes = co_await station_->transact(std::move(t));
  if (!bytes) co_return fail(bytes.error());
  co_return Result<>();
}

// Asks for its name, if it has one. On a shared line the others' late replies to ID and VER look like its
// own.
std::optional<Station::Unmistakable> Conversation::unmistakable(const OutstandingReplies& outstanding,
                                                                Instant now) const {
  const auto may_ask = [&](ReplyKind reply_kind) { return !outstanding.may_be_outstanding(reply_kind, now); };
  if (named_ && may_ask(reply_kinds::name))
    return identity_question("DN", [this](std::string_view text) { return is_its_name(text); });
  if (product_known_ && may_ask(reply_kinds::product) && !station_->others_outstanding(reply_kinds::product))
    return identity_question("ID",
                             [this](std::string_view text) { return text == console_.model().product; });
  if (may_ask(reply_kinds::version) && !station_->others_outstanding(reply_kinds::version))
    return identity_question("VER", reply_kinds::is_version);
  return std::nullopt;
}

Station::Unmistakable Conversation::identity_question(std::string_view question,
                                                      std::function<bool(std::string_view)> is_it) const {
  Transaction t(framed(question, Priority::poll, console_.catalog.address),
                framing() == Framing::message ? ReplyShape::message() : ReplyShape::text(), Priority::poll);
  t.reply_kind = reply_kinds::of_question(console_.forms, question);
  t.prompt = true;
  t.unsolicited_length = [is_it](std::string_view bytes) {
    return reply_kinds::others_at_front(bytes, is_it);
  };
  const auto is_answer = [is_it](std::string_view answer) { return is_it(decode_reply(answer).text); };
  return {std::move(t), is_answer};
}

// Until a power cycle a renamed device answers at its old address with its new name. On USB it is alone.
bool Conversation::is_its_name(std::string_view text) const {
  const auto number = number_in_name(console_.model(), text);
  return number &&
         (*number == console_.catalog.address || number == also_called_ || framing() == Framing::message);
}

void Conversation::know_name(std::string_view name) {
  also_called_ = number_in_name(console_.model(), name);
  named_ = also_called_.has_value();
}

// ---- questions

// A question is asked once more if its reply was garbled or missing. The second reply is accepted only if
// nothing follows it: two devices that reply at once can look like one.
Task<Result<std::string>> Conversation::ask(std::string question, Priority priority, bool again) {
  auto reply = co_await exchange_question(question, priority, again);
  if (!reply && !again && worth_another_try(reply.error())) {
    if (station_ && reply.error().kind == FaultKind::garbled)
      station_->doubt(reply_kinds::of_question(console_.forms, question));
    reply = co_await exchange_question(question, priority, true);
  }
  if (!reply) co_return fail(reply.error());
  if (reply->refused()) co_return refusal(question, reply->text);
  co_return std::move(reply->text);
}

Task<Result<Reply>> Conversation::exchange_question(std::string question, Priority priority, bool again) {
  const int unexpected_before = unexpected_;
  auto reply = co_await exchange(std::move(question), priority, usual_patience, true);
  if (!again || !reply) co_return reply;
  co_await wait_for_quiet();
  if (unexpected_ != unexpected_before) co_return two_devices_answer();
  co_return reply;
}

Task<Result<std::string>> Conversation::ask_for(std::string question,
                                                std::function<bool(std::string_view)> makes_sense,
                                                Priority priority) {
  if (priority == Priority::poll && urgent.is_due && urgent.is_due()) co_await urgent.ask();
  std::string text;
  for (const bool again : {false, true}) {
    auto reply = co_await ask(question, priority, again);
    if (!reply && (reply.error().kind != FaultKind::refused || again)) co_return fail(reply.error());
    if (reply && makes_sense(*reply)) co_return reply;
    if (reply) {
      text = *reply;
      if (station_) station_->doubt(reply_kinds::of_question(console_.forms, question));
    } else {
      co_await wait_for_quiet();  // the question itself may have been garbled
    }
  }
  co_return reply_not_understood(question, text);
}

Task<Result<std::vector<std::int64_t>>> Conversation::ask_numbers(std::string question, std::size_t count,
                                                                  Priority priority) {
  std::function<bool(std::string_view)> is_it = [count](std::string_view text) {
    const auto numbers = decode_numbers(text, count);
    return numbers && numbers->size() == count;
  };
  auto text = co_await ask_for(std::move(question), std::move(is_it), priority);
  if (!text) co_return fail(text.error());
  co_return *decode_numbers(*text, count);
}

Task<Result<std::int64_t>> Conversation::ask_number(std::string question, Priority priority) {
  auto numbers = co_await ask_numbers(std::move(question), 1, priority);
  if (!numbers) co_return fail(numbers.error());
  co_return numbers->front();
}

Task<Result<std::int64_t>> Conversation::ask_confirmed(std::string question, Decode decode,
                                                       std::optional<std::int64_t> expected,
                                                       Priority priority) {
  constexpr int attempts = 4;
  int unexpected_before = unexpected_;  // with unexpected texts, each reply may be doubled in the same way
  std::function<bool(std::string_view)> makes_sense = [&decode](std::string_view text) {
    return decode(text).has_value();
  };
  for (int attempt = 0; attempt < attempts; ++attempt) {
    auto text = co_await ask_for(question, makes_sense, priority);
    if (!text) co_return fail(text.error());
    const std::int64_t value = *decode(*text);
    const int unexpected_now = std::exchange(unexpected_before, unexpected_);
    if (value == expected && (attempt == 0 || unexpected_now == unexpected_)) co_return value;
    expected = value;
  }
  co_return fail(FaultKind::garbled, fmt::format("The replies to {} differ each time.", question),
                 fmt::format("It was sent {} times.", attempts),
                 "Check the cable, and whether the value changes all the time.");
}

// ---- commands

// A stop is sent on a dirty line too: its OK may then belong to an older command.
Task<Result<>> Conversation::command(std::string text, Priority priority, Duration patience) {
  const Instant now = console_.scheduler.now();
  const bool may_be_older = priority == Priority::stop && station_ &&
                            (station_->outstanding().may_be_outstanding(reply_kinds::done, now) ||
                             station_->outstanding().may_be_outstanding(reply_kinds::text, now));
  auto reply = co_await exchange(text, priority, patience);
  if (!reply) co_return fail(reply.error());
  if (may_be_older && (reply->text == "OK" || reply->refused()))
    co_return fail(FaultKind::no_answer,
                   fmt::format("Whether {} was the reply to {} is unknown.", printable(reply->text), text),
                   "It was sent.");
  if (reply->refused()) co_return refusal(text, reply->text);
  if (reply->text == "OK") co_return Result<>();
  co_return fail(FaultKind::garbled,
                 fmt::format("The controller answered {} to {} instead of OK.", printable(reply->text), text),
                 "It was sent once and is not repeated.", "Check whether it was done before you try again.");
}

Task<Result<>> Conversation::broadcast(std::string text, Priority priority) {
  if (!station_) co_return no_connection();
  const Model& model = console_.model();
  if (model.broadcast < 0 || station_->carries_messages())
    co_return fail(FaultKind::refused, fmt::format("A {} has no broadcast address.", model.title),
                   "Nothing was sent.");
  if (goes_out) goes_out(bare_text(text));
  Transaction t(framed(text, priority, model.broadcast), ReplyShape::nothing(), priority);
  t.on_dirty_line = true;  // no reply is due
  auto sent = co_await station_->transact(std::move(t));
  if (!sent) co_return fail(sent.error());
  co_return Result<>();
}

// ---- unsolicited texts

// Gives up if another program keeps the line busy.
Task<> Conversation::wait_for_quiet() {
  const bool slow = station_ && station_->lateness() > Duration::zero();
  const auto [quiet_time, longest_noise] = slow ? quiet_of_slow_line : usual_quiet;
  const Instant give_up = console_.scheduler.now() + longest_noise;
  Instant quiet_at = console_.scheduler.now() + quiet_time;
  while (station_ && console_.scheduler.now() < quiet_at) {
    auto waited = co_await station_->pause(quiet_at - console_.scheduler.now());
    if (!waited) co_return;
    quiet_at = std::min(std::max(quiet_at, received_at_ + quiet_time), give_up);
  }
}

// $NNP of this device, or a complete text that no question waits for. Late replies do not count as
// unexpected.
std::size_t Conversation::receive_unsolicited(std::string_view bytes) {
  received_at_ = console_.scheduler.now();
  if (bytes.find_first_not_of('\n') == bytes.npos) return ++line_feeds_, 0;
  if (const std::size_t length = unsolicited_at_front(bytes); length != 0) {
    if (length == std::string_view::npos) return length;
    if (in_position(bytes.substr(0, length)) != console_.catalog.address) return 0;
    console_.texts.add(std::string(text_of(bytes.substr(0, length))));
    console_.changed();
    return length;
  }
  if (const std::size_t refusal = refusal_of_cut_at_front(bytes); refusal != 0) {
    if (station_) station_->discount_received();
    return refusal;
  }
  if (is_other_devices_name(bytes)) return 0;
  ++texts_received_;
  if (station_ && !station_->is_dirty() && !station_->others_outstanding()) ++unexpected_;
  return 0;
}

// A late reply to another, never taken for ours.
bool Conversation::is_other_devices_name(std::string_view bytes) const {
  const bool whole = bytes.find_first_of(std::string_view("\r\0", 2)) == bytes.size() - 1;
  const auto number = number_in_name(console_.model(), decode_reply(bytes).text);
  return whole && number && *number != console_.catalog.address;
}

// ---- sentences

tl::unexpected<Fault> Conversation::no_connection() const { return not_connected("controller"); }

tl::unexpected<Fault> Conversation::refusal(std::string_view sent, std::string_view reply) const {
  return fail(FaultKind::refused, fmt::format("The controller refused {} with {}: {}.", sent,
                                              printable(reply), explain_refusal(console_.model(), reply)));
}

tl::unexpected<Fault> Conversation::two_devices_answer() const {
  const std::string_view prefix = console_.model().name_prefix;
  return fail(
      FaultKind::garbled,
      fmt::format("More than one device answers at address {:02}, or another program uses this line.",
                  console_.catalog.address),
      "The reply was not used.",
      fmt::format("Connect one of them alone, give it another device name ({}01 to {}99), Store, switch "
                  "its power off and on.",
                  prefix, prefix));
}

}  // namespace hw::arcus
