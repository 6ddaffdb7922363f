// Questions and commands, and what the device says unasked. The user's own text: driver_text.cpp.
#include <algorithm>

#include <fmt/core.h>

#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr Duration usual_patience = Millis(200);
struct Quiet {
  Duration time, longest_noise;
};
constexpr Quiet usual_quiet{Millis(30), Millis(300)};
constexpr Quiet quiet_of_a_slow_one{Millis(45), Millis(800)};  // bytes come up to 40 ms apart

std::string printable(std::string_view bytes) {
  std::string all;
  for (const char c : bytes.substr(0, 40))
    all += c >= ' ' && c < 127 ? std::string(1, c) : fmt::format("<{:02X}>", static_cast<unsigned char>(c));
  return all;
}

tl::unexpected<Fault> means_nothing(std::string_view question, std::string_view reply) {
  return fail(FaultKind::garbled,
              fmt::format("The controller answered {} to {}, which means nothing.",
                          reply.empty() ? "with an empty text" : printable(reply), question),
              "It was asked twice.",
              "Look at the cable and the line rate, and whether two devices have one address or another "
              "program talks on this line.");
}

}  // namespace

Framing ArcusDriver::framing() const {
  return station_ && station_->carries_messages() ? Framing::message : Framing::addressed;
}

tl::unexpected<Fault> ArcusDriver::no_connection() const {
  return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
}

// One command and its reply. Replies carry no address (but with RT=1), so while an answer that was given up
// on may still come, this one is believed only with the device's name: before it where this device is the
// late one, behind it where another on the line is. A stop waits for none of this.
Task<Result<Reply>> ArcusDriver::exchange(std::string text, Priority priority, Duration patience,
                                          bool own_question) {
  if (!station_) co_return no_connection();
  const bool anothers = address_of(text) >= 0 && address_of(text) != catalog_.address;
  const std::string said = anothers ? std::string() : command_in(text);
  may_set(said);
  const bool must_be_sure = own_question || priority != Priority::stop;
  if (must_be_sure && station_->is_dirty()) {
    auto named = co_await hear_its_name(priority);
    if (!named && !own_question && named.error().kind == FaultKind::no_answer)
      co_return fail(FaultKind::refused, "The controller does not answer, not even with its name.",
                     fmt::format("{} was not sent.", text));
    if (!named) co_return fail(named.error());
  }
  const int strays_before = strays_;
  forget_thread(said);  // whether or not it is confirmed
  const auto called_before = note_call(said);
  auto reply = co_await say(text, priority, patience, own_question);
  if (said.starts_with("GS") && (reply ? reply->refused() : was_kept_back(reply.error())))
    called_ = called_before;
  if (!reply || !must_be_sure || !station_ || !(station_->is_dirty() || station_->others_owe())) co_return reply;
  auto named = co_await hear_its_name(priority);
  if (!named) co_return fail(named.error());
  if (strays_ != strays_before)
    co_return fail(
        FaultKind::garbled,
        fmt::format("{} was answered twice: one of the answers came too late and is another's.", text),
        "Neither was used.");
  co_return reply;
}

Task<Result<Reply>> ArcusDriver::say(std::string text, Priority priority, Duration patience,
                                     bool own_question) {
  if (!station_) co_return no_connection();
  const bool usb = station_->carries_messages();
  Transaction t(frame(framing(), catalog_.address, text), usb ? ReplyShape::message() : ReplyShape::text(),
                priority);
  t.patience = std::max(patience, least_patience_);
  t.prompt = own_question;
  t.own_question = own_question && priority != Priority::transfer;
  t.names_itself = text_of(text) == "DN";
  if (!usb && t.names_itself) t.stranger = unasked_at_front;
  if (!usb && !t.names_itself)
    t.stranger = [&m = model()](std::string_view bytes) { return unasked_or_name_at_front(m, bytes); };
  auto bytes = co_await station_->transact(std::move(t));
  if (!bytes) co_return fail(bytes.error());
  if (!usb && bytes->starts_with('\n')) ++line_feeds_;  // it stood behind the answer before
  Reply reply = decode_reply(*bytes);
  const int asked = std::max(address_of(text), catalog_.address);
  if (reply.id && address_of(text) < 0 && *reply.id != asked)
    co_return fail(
        FaultKind::garbled,
        fmt::format("Device {:02} was asked {}, and device {:02} answered.", asked, text, *reply.id),
        "Its answer was not used.",
        "Two programs may be talking on this line, or an answer came too late. Close the other "
        "program.");
  co_return reply;
}

// What comes before its name is a late answer, whoever it is from: it is left to hear().
Task<Result<>> ArcusDriver::hear_its_name(Priority priority) {
  if (!station_) co_return no_connection();
  const bool usb = station_->carries_messages();
  Transaction t(frame(framing(), catalog_.address, "DN"), usb ? ReplyShape::message() : ReplyShape::text(),
                priority);
  t.patience = std::max(usual_patience, least_patience_);
  t.prompt = true;
  t.own_question = priority != Priority::transfer;
  t.names_itself = true;
  t.stranger = [&m = model()](std::string_view bytes) { return no_name_at_front(m, bytes); };
  auto bytes = co_await station_->transact(std::move(t));
  if (!bytes) co_return fail(bytes.error());
  const Reply reply = decode_reply(*bytes);
  if (!is_its_name(reply.text))
    co_return fail(
        FaultKind::garbled,
        fmt::format("Device {:02} was asked its name, and {} answered.", catalog_.address, reply.text),
        "Nothing was used that came before.");
  if (station_) station_->has_caught_up();
  co_return Result<>();
}

// Until it is switched off and on it answers at its old address and tells its new name. On USB it is alone.
bool ArcusDriver::is_its_name(std::string_view text) const {
  const auto number = number_in_name(model(), text);
  const auto set_to = param("DN");
  return number &&
         (*number == catalog_.address || !set_to || *number == *set_to || framing() == Framing::message);
}

tl::unexpected<Fault> ArcusDriver::refusal(std::string_view sent, std::string_view reply) const {
  return fail(FaultKind::refused, fmt::format("The controller refused {} with {}: {}.", sent,
                                              printable(reply), explain_refusal(model(), reply)));
}

// A question may be asked once more when its answer was garbled or did not come. Commands never are. The
// second answer is believed only if nothing comes behind it: two that speak at once can sound like one.
Task<Result<std::string>> ArcusDriver::ask(std::string question, Priority priority, bool again) {
  auto reply = co_await exchange_question(question, priority, again);
  if (!reply && !again && worth_another_try(reply.error())) {
    co_await wait_for_quiet();
    reply = co_await exchange_question(question, priority, true);
  }
  if (!reply) co_return fail(reply.error());
  if (reply->refused()) co_return refusal(question, reply->text);
  co_return std::move(reply->text);
}

Task<Result<Reply>> ArcusDriver::exchange_question(std::string question, Priority priority, bool again) {
  const int strays_before = strays_;
  auto reply = co_await exchange(std::move(question), priority, usual_patience, true);
  if (!again || !reply) co_return reply;
  co_await wait_for_quiet();
  if (strays_ != strays_before) co_return two_answer();
  co_return reply;
}

Task<Result<std::vector<std::int64_t>>> ArcusDriver::ask_numbers(std::string question, std::size_t count,
                                                                 Priority priority) {
  std::string text;
  for (const bool again : {false, true}) {
    auto reply = co_await ask(question, priority, again);
    if (!reply && (reply.error().kind != FaultKind::refused || again)) co_return fail(reply.error());
    if (reply) {
      text = *reply;
      auto numbers = decode_numbers(text, count);
      if (numbers && numbers->size() == count) co_return std::move(*numbers);
    }
    co_await wait_for_quiet();  // the question itself may have been garbled on its way
  }
  co_return means_nothing(question, text);
}

Task<Result<std::int64_t>> ArcusDriver::ask_number(std::string question, Priority priority) {
  auto numbers = co_await ask_numbers(std::move(question), 1, priority);
  if (!numbers) co_return fail(numbers.error());
  co_return numbers->front();
}

Task<Result<>> ArcusDriver::command(std::string text, Priority priority, Duration patience) {
  auto reply = co_await exchange(text, priority, patience);
  if (!reply) co_return fail(reply.error());
  if (reply->refused()) co_return refusal(text, reply->text);
  if (reply->text == "OK") co_return Result<>();
  co_return fail(FaultKind::garbled,
                 fmt::format("The controller answered {} to {} instead of OK.", printable(reply->text), text),
                 "It was sent once and is not repeated.", "Look whether it was done before you try again.");
}

// To every device of the line; none answers.
Task<Result<>> ArcusDriver::broadcast(std::string text, Priority priority) {
  if (!station_) co_return no_connection();
  if (model().broadcast < 0 || station_->carries_messages())
    co_return fail(FaultKind::refused,
                   fmt::format("A {} has no address that speaks to all devices of a line.", model().title),
                   "Nothing was sent.");
  may_set(bare_text(text));
  Transaction t(frame(Framing::addressed, model().broadcast, text), ReplyShape::nothing(), priority);
  auto sent = co_await station_->transact(std::move(t));
  if (!sent) co_return fail(sent.error());
  co_return Result<>();
}

// After an answer that made no sense: what still comes must not be taken for the next one. Where another
// program talks all the time it never is quiet.
Task<> ArcusDriver::wait_for_quiet() {
  const auto [quiet_time, longest_noise] =
      least_patience_ > Duration::zero() ? quiet_of_a_slow_one : usual_quiet;
  const Instant give_up = scheduler_.now() + longest_noise;
  Instant quiet_at = scheduler_.now() + quiet_time;
  while (station_ && scheduler_.now() < quiet_at) {
    auto waited = co_await station_->pause(quiet_at - scheduler_.now());
    if (!waited) co_return;
    quiet_at = std::min(std::max(quiet_at, heard_at_ + quiet_time), give_up);
  }
}

// ---- what comes unasked

// $NNP of this device; or a whole text that no question waits for.
std::size_t ArcusDriver::hear(std::string_view bytes) {
  heard_at_ = scheduler_.now();
  if (bytes.find_first_not_of('\n') == bytes.npos) return ++line_feeds_, 0;
  if (const std::size_t length = unasked_at_front(bytes); length != 0) {
    if (length == std::string_view::npos) return length;
    if (in_position(bytes.substr(0, length)) != catalog_.address) return 0;
    texts_.add(std::string(text_of(bytes.substr(0, length))));
    changed_();
    return length;
  }
  if (!is_anothers_name(bytes)) ++strays_;
  return 0;
}

// Late, and taken for no answer of ours.
bool ArcusDriver::is_anothers_name(std::string_view bytes) const {
  const bool whole = bytes.find_first_of(std::string_view("\r\0", 2)) == bytes.size() - 1;
  const auto number = number_in_name(model(), decode_reply(bytes).text);
  return whole && number && *number != catalog_.address;
}

void ArcusDriver::tell(Notice::Kind kind, std::string text) {
  notify_(Notice(kind, scheduler_.now(), std::move(text)));
}

}  // namespace hw::arcus
