#include "core/devices/vme58/conversation.h"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "core/devices/vme58/codec.h"

namespace hw::vme58 {
namespace {

constexpr Duration ring_look = std::chrono::microseconds(500);
constexpr Duration taking_patience = Millis(250);  // the board takes text at once unless a queue is full
constexpr Duration stop_patience = Millis(20);     // then the mailbox stops all axes
constexpr Duration greeting_patience =
    std::chrono::seconds(3);  // after this time the greeting may be lost, and is requested again
constexpr std::string_view greeting_question = "WY";

bool is_greeting(std::string_view reply) { return decode_greeting(reply).has_value(); }

Fault not_understood(std::string_view reply, std::string_view question) {
  return Fault(FaultKind::garbled,
               fmt::format("The board answered \"{}\" to {}, which is not a valid reply.", reply,
                           without_end(question)),
               "It is asked again.");
}

}  // namespace

// ---- ownership of the rings

Task<Result<>> Conversation::take_over() {
  auto found = co_await find_end(Priority::intent);
  if (!found) co_return found;
  auto let = co_await let_go();
  if (!let) co_return let;
  lose();
  known_ = true;
  std::vector<BusCycle>& cycles = wire_.burst();
  cycles.push_back(BusCycle::store(2, at::input_get_index, static_cast<std::uint32_t>(get_)));
  cycles.push_back(BusCycle::store(1, reg::control, wire_.enabled()));
  co_return co_await wire_.run(cycles, Priority::intent);
}

Task<Result<>> Conversation::let_go() {
  const auto input_put = co_await wire_.read_index(at::input_put_index, Priority::intent);
  if (!input_put) co_return fail(input_put.error());
  get_ = *input_put;
  co_return Result<>();
}

void Conversation::lose() {
  known_ = false;
  received_.clear();
  replies_.clear();
  owed_.reset();
}

Task<Result<>> Conversation::find_end(Priority priority) {
  const auto put = co_await wire_.read_index(at::output_put_index, priority);
  if (!put) co_return fail(put.error());
  put_ = *put;
  co_return Result<>();
}

// ---- commands

// Another host on the bus may have put text since, and selected another axis.
Task<Result<bool>> Conversation::put(std::string text, Priority priority) {
  const int own_end = put_;
  if (auto found = co_await find_end(priority); !found) co_return fail(found.error());
  if (put_ != own_end) selection_.lose();
  const auto get = co_await wire_.read_index(at::output_get_index, priority);
  if (!get) co_return fail(get.error());
  if (room(put_, *get) < static_cast<int>(text.size())) co_return false;
  auto stands = co_await fill(text, put_, priority);
  if (!stands) co_return fail(stands.error());
  std::vector<BusCycle>& cycles = wire_.burst();
  const int end = advanced(put_, static_cast<int>(text.size()));
  // Writes the host's other index too: another program may have spoiled it, and the board takes nothing while
  // it is invalid.
  cycles.push_back(BusCycle::store(2, at::input_get_index, static_cast<std::uint32_t>(get_)));
  cycles.push_back(BusCycle::store(2, at::output_put_index, static_cast<std::uint32_t>(end)));
  auto published = co_await wire_.run(cycles, priority);
  if (!published) co_return fail(published.error());
  on_its_way_ = true;
  in_wq_ = in_wq_ || text.find("WQ") != text.npos;
  put_ = end;
  last_sent_ = text;
  if (priority != Priority::poll) last_not_polled_ = text;
  wire_.record(Way::sent, priority, text);
  co_return true;
}

// A silent bus loses stored bytes without an error. Half a text is another command ("AR MR-44024" without its
// AR moves the previously selected axis), so the index is advanced only when the whole text is in the ring.
Task<Result<>> Conversation::fill(std::string_view text, int from, Priority priority) {
  std::vector<BusCycle>& cycles = wire_.burst();
  append_text(cycles, text, from);
  auto done = co_await wire_.run(cycles, priority);
  if (!done) co_return done;
  if (reply_text(std::span(cycles).subspan(text.size())) == text) co_return Result<>();
  co_return fail(FaultKind::garbled, "The command ring does not contain the text that was written into it.",
                 "The bus has lost the text.", "Check the bus, then send the text again.");
}

Task<Result<bool>> Conversation::is_taken(Priority priority) {
  const auto get = co_await wire_.read_index(at::output_get_index, priority);
  if (!get) co_return fail(get.error());
  if (*get == put_) on_its_way_ = false;
  co_return *get == put_;
}

bool Conversation::is_taken_up_to(int output_get, int output_put) {
  if (output_get != output_put) return false;
  on_its_way_ = in_wq_ = false;
  return true;
}

// Blanks the text from `from` on that the board has not read: it then has no effect, wherever the board is in
// it. True: the board had read none of it.
Task<Result<bool>> Conversation::withdraw(Priority priority, int from) {
  const auto get = co_await wire_.read_index(at::output_get_index, priority);
  if (!get) co_return fail(get.error());
  const int begin = waiting(put_, *get) < waiting(put_, from) ? *get : from;
  const std::string blanks(static_cast<std::size_t>(waiting(put_, begin)), ' ');
  if (blanks.empty()) co_return false;
  selection_.lose();
  if (owed_) owed_->greeting_asked.reset();  // the WY behind the question may have been blanked
  auto filled = co_await fill(blanks, begin, priority);
  if (!filled) co_return fail(filled.error());
  const auto stands = co_await wire_.read_index(at::output_get_index, priority);
  if (!stands) co_return fail(stands.error());
  co_return waiting(put_, *stands) >= waiting(put_, from);
}

Task<Result<>> Conversation::withdraw_all(Priority priority) {
  const auto withdrawn = co_await withdraw(priority, advanced(put_, 1 - ring_cells));
  co_return withdrawn ? Result<>() : fail(withdrawn.error());
}

Task<Result<>> Conversation::select_again(Priority priority) {
  if (!selection_.is_lost() || selection_.recording()) co_return Result<>();
  std::string text = selection_.selector() + "\n";
  auto written = co_await write(std::move(text), priority);
  if (written) selection_.is_restored();
  co_return written;
}

Task<Result<>> Conversation::write(std::string text, Priority priority, WhenStuck when_stuck) {
  const Instant give_up = wire_.now() + (priority == Priority::stop ? stop_patience : taking_patience);
  taken_back_ = false;
  auto is_put = co_await put(text, priority);
  while (is_put && !*is_put && wire_.now() < give_up) {
    auto paused = co_await wire_.pause(ring_look);
    if (!paused) co_return paused;
    is_put = co_await put(text, priority);
  }
  if (!is_put) co_return fail(is_put.error());
  const int begin = advanced(put_, -static_cast<int>(text.size()));  // of the text just put
  bool taken = false;
  while (*is_put && !taken) {
    const auto looked = co_await is_taken(priority);
    if (!looked) co_return fail(looked.error());
    taken = *looked;
    if (taken || wire_.now() >= give_up) break;
    auto paused = co_await wire_.pause(ring_look);
    if (!paused) co_return paused;
  }
  if (taken) co_return Result<>();
  const bool waits = *is_put && when_stuck == WhenStuck::leave;
  if (*is_put && !waits) {
    const auto withdrawn = co_await withdraw(priority, begin);
    if (!withdrawn) co_return fail(withdrawn.error());
    taken_back_ = *withdrawn;
  }
  co_return fail(FaultKind::no_answer,
                 "The board accepts no command now: a command queue is full, or it waits in WQ.",
                 waits ? "The commands wait in the ring and will be carried out when there is room."
                       : "The commands were removed from the ring.",
                 "Wait until its queues have room, or stop the axes.");
}

// ---- questions

Task<Result<std::string>> Conversation::ask(std::string question, Priority priority, ReplyForm form,
                                            Duration patience) {
  auto replies = co_await converse(std::move(question), 1, priority, form, patience, false);
  if (!replies) co_return fail(replies.error());
  co_return std::move(replies->front());
}

Task<Result<std::vector<std::string>>> Conversation::ask_several(std::string text, std::size_t count,
                                                                 Priority priority, ReplyForm form) {
  std::string closed = std::string(without_end(text)) + " WY\n";
  co_return co_await converse(std::move(closed), count, priority, form, Millis(200), true);
}

/// `closes`: a greeting follows the replies.
Task<Result<std::vector<std::string>>> Conversation::converse(std::string text, std::size_t count,
                                                              Priority priority, ReplyForm form,
                                                              Duration patience, bool closes) {
  auto clear = co_await wait_for_abandoned(priority);
  if (!clear) co_return fail(clear.error());
  const Instant asked_at = wire_.now();
  const int put_before = put_;
  std::vector<std::string> replies;
  auto asked = co_await write(text, priority);
  if (put_ != put_before) owed_ = Owed{};  // in case a stop ends this before the reply arrives
  if (asked) asked = co_await collect(replies, count, priority, asked_at + patience, text, closes);
  if (!asked) co_return fail(asked.error());
  for (const std::string& reply : replies)
    if (!fits(form, reply)) co_return fail(not_understood(reply, text));
  owed_.reset();
  wire_.count_answer(asked_at, priority == Priority::poll);
  co_return replies;
}

Task<Result<>> Conversation::collect(std::vector<std::string>& replies, std::size_t count, Priority priority,
                                     Instant give_up, std::string_view question, bool closes) {
  const bool greets = question.find(greeting_question) != question.npos;
  for (;;) {
    auto fetched = co_await fetch_all(priority);
    if (!fetched) co_return fetched;
    bool closed = false;
    while (!replies_.empty() && !closed && (closes || replies.size() < count)) {
      std::string reply = std::move(replies_.front());
      replies_.pop_front();
      closed = closes && is_greeting(reply);
      if (!greets && is_greeting(reply)) continue;  // a late reply to an earlier WY
      wire_.record(Way::received, priority, reply);
      if (!closed) replies.push_back(std::move(reply));
    }
    if (closed) owed_.reset();
    if (!closes && replies.size() == count) co_return Result<>();
    if (closed && replies.size() == count) co_return Result<>();
    if (closed || wire_.now() > give_up) break;
    auto paused = co_await wire_.pause(ring_look);
    if (!paused) co_return paused;
  }
  const auto bad = co_await readings_.was_rejected(priority);
  if (bad && *bad) {
    owed_.reset();
    co_return rejected_by_board(question);
  }
  if (closes && !owed_) {
    const std::string lines = fmt::format("{} lines", replies.size());
    co_return fail(not_understood(lines, question));
  }
  wire_.count_miss();
  co_return fail(FaultKind::no_answer,
                 fmt::format("The board did not answer {} in time.", without_end(question)));
}

/// Waits for owed replies, so that none of them is taken for the reply to the next question.
Task<Result<>> Conversation::wait_for_abandoned(Priority priority) {
  auto fetched = co_await fetch_all(priority);
  if (!fetched) co_return fetched;
  if (owed_ && !owed_->greeting_asked) {
    give_unsolicited();
    const int put_before = put_;
    auto asked = co_await write(std::string(greeting_question) + "\n", priority);
    if (put_ != put_before && owed_) owed_->greeting_asked = wire_.now();
    if (!asked) co_return asked;
  }
  const Instant give_up = wire_.now() + (priority == Priority::stop ? stop_patience : taking_patience);
  while (owed_ && !take_greeting()) {
    if (wire_.now() >= give_up) {
      if (wire_.now() > *owed_->greeting_asked + greeting_patience) owed_->greeting_asked.reset();
      co_return fail(FaultKind::no_answer, "The board has not answered an earlier query yet.",
                     "Nothing was sent.");
    }
    auto paused = co_await wire_.pause(ring_look);
    if (!paused) co_return paused;
    fetched = co_await fetch_all(priority);
    if (!fetched) co_return fetched;
    if (owed_ && !owed_->greeting_asked) break;  // the WY was taken back with the other text in the ring
  }
  give_unsolicited();
  co_return Result<>();
}

/// Whether the greeting requested behind the owed replies has arrived: all owed replies have then arrived
/// before it.
bool Conversation::take_greeting() {
  while (!replies_.empty()) {
    const bool came = owed_->greeting_asked && is_greeting(replies_.front());
    replies_.pop_front();
    if (!came) continue;
    owed_.reset();
    return true;
  }
  return false;
}

Task<Result<>> Conversation::receive(int input_put, Priority priority) {
  auto fetched = co_await fetch(input_put, priority);
  if (!fetched) co_return fetched;
  if (!owed_ || take_greeting()) give_unsolicited();
  co_return Result<>();
}

Task<Result<>> Conversation::fetch_all(Priority priority) {
  const auto input_put = co_await wire_.read_index(at::input_put_index, priority);
  if (!input_put) co_return fail(input_put.error());
  co_return co_await fetch(*input_put, priority);
}

Task<Result<>> Conversation::fetch(int input_put, Priority priority) {
  const int count = waiting(input_put, get_);
  if (count == 0) co_return Result<>();
  std::vector<BusCycle>& cycles = wire_.burst();
  append_reply_reads(cycles, get_, count);
  cycles.push_back(BusCycle::store(2, at::input_get_index, static_cast<std::uint32_t>(input_put)));
  auto done = co_await wire_.run(cycles, priority);
  if (!done) co_return done;
  cycles.pop_back();
  get_ = input_put;
  received_ += reply_text(cycles);
  while (auto reply = take_reply(received_, echo_)) replies_.push_back(std::move(*reply));
  co_return Result<>();
}

/// Unclaimed replies to raw text go to scripts; replies to abandoned questions are dropped.
void Conversation::give_unsolicited() {
  for (; !replies_.empty(); replies_.pop_front()) {
    if (owed_) continue;
    wire_.record_unsolicited(replies_.front());
    texts_.add(std::move(replies_.front()));
  }
}

}  // namespace hw::vme58
