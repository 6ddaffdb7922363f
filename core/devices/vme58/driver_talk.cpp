// The rings: commands in, replies out.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr Duration ring_look = std::chrono::microseconds(500);
constexpr Duration taking_patience = Millis(250);  // the board takes text at once unless a queue is full
constexpr Duration stop_patience = Millis(20);     // then the mailbox stops all
constexpr int index_attempts = 3;

TrafficKind kind_of(Priority priority) {
  switch (priority) {
    case Priority::stop: return TrafficKind::stop;
    case Priority::intent: return TrafficKind::intent;
    case Priority::transfer: return TrafficKind::transfer;
    case Priority::poll: return TrafficKind::poll;
  }
  return TrafficKind::intent;
}

}  // namespace

Fault when_put(Fault why) {
  if (why.kind != FaultKind::stopped) return why;
  return Fault(FaultKind::no_answer, "A stop came while this was under way.",
               "Whether the board has carried it out is not known.");
}

tl::unexpected<Fault> Vme58Driver::no_connection() const {
  return fail(FaultKind::lost, "There is no connection to the board.", "Nothing was sent.");
}

Task<Result<>> Vme58Driver::run(std::vector<BusCycle>& cycles, Priority priority) {
  if (!station_) co_return no_connection();
  if (!station_->is_window())
    co_return fail(FaultKind::refused, "A VME58 is a board in a memory window, not a device on a line.",
                   "Nothing was sent.", "Open it through vme or bus.");
  co_return co_await station_->bus(cycles, priority);
}

/// Empty. It is used up when the next one is begun.
std::vector<BusCycle>& Vme58Driver::burst() {
  cycles_.clear();
  return cycles_;
}

Task<Result<>> Vme58Driver::pause(Duration time) {
  if (!station_) co_return no_connection();
  co_return co_await station_->pause(time);
}

// Read twice: while the board moves it, or when a byte was garbled, the two differ.
Task<Result<int>> Vme58Driver::read_index(std::uint16_t offset, Priority priority) {
  std::vector<BusCycle>& cycles = burst();
  for (int attempt = 0; attempt < index_attempts; ++attempt) {
    cycles.assign(2, BusCycle::read(2, offset));
    auto done = co_await run(cycles, priority);
    if (!done) co_return fail(done.error());
    if (cycles[0].value == cycles[1].value && is_index(cycles[0].value))
      co_return static_cast<int>(cycles[0].value);
  }
  co_return fail(FaultKind::garbled,
                 fmt::format("An index of the rings reads {:04X}, which no VME58 shows.", cycles[1].value),
                 "It was read several times.",
                 "Look whether another program resets the board, and at the bus.");
}

// One burst, whole or not at all: nobody else's text gets in between. False: it does not fit now.
Task<Result<bool>> Vme58Driver::put_text(std::string text, Priority priority) {
  const auto get = co_await read_index(at::output_get_index, priority);
  if (!get) co_return fail(get.error());
  if (room(put_, *get) < static_cast<int>(text.size())) co_return false;
  std::vector<BusCycle>& cycles = burst();
  // Where a stranger has spoiled the host's other index the board takes nothing.
  cycles.push_back(BusCycle::store(2, at::input_get_index, static_cast<std::uint32_t>(get_)));
  append_text(cycles, text, put_);
  auto done = co_await run(cycles, priority);
  if (!done) co_return fail(done.error());
  on_its_way_ = true;
  in_wq_ = in_wq_ || text.find("WQ") != text.npos;
  put_ = advanced(put_, static_cast<int>(text.size()));
  last_sent_ = text;
  if (priority != Priority::poll) last_said_ = text;
  record(Way::sent, priority, text);
  co_return true;
}

Task<Result<bool>> Vme58Driver::is_taken(Priority priority) {
  const auto get = co_await read_index(at::output_get_index, priority);
  if (!get) co_return fail(get.error());
  if (*get == put_) on_its_way_ = false;
  co_return *get == put_;
}

// Text from `from` on that the board has not come to is made blank: it does nothing then, wherever the board
// stands in it.
Task<Result<>> Vme58Driver::withdraw_text(Priority priority, int from) {
  const auto get = co_await read_index(at::output_get_index, priority);
  if (!get) co_return fail(get.error());
  const int begin = waiting(put_, *get) < waiting(put_, from) ? *get : from;
  std::vector<BusCycle>& cycles = burst();
  for (int i = begin; i != put_; i = advanced(i, 1))
    cycles.push_back(BusCycle::store(2, static_cast<std::uint16_t>(at::output_buffer + 2 * i), ' '));
  if (cycles.empty()) co_return Result<>();
  selection_lost_ = true;
  co_return co_await run(cycles, priority);
}

/// The board stands at the axis that the user's text has selected, also after text was taken back.
Task<Result<>> Vme58Driver::select_again(Priority priority) {
  if (!selection_lost_ || context_.recording) co_return Result<>();
  std::string text = context_.selector() + "\n";
  auto written = co_await write(std::move(text), priority);
  if (written) selection_lost_ = false;
  co_return written;
}

/// Returns when the board has taken it. Text that would wait behind a full queue and act at an unexpected
/// time is taken back, unless it may wait.
Task<Result<>> Vme58Driver::write(std::string text, Priority priority, WhenStuck when_stuck) {
  const Instant give_up = scheduler_.now() + (priority == Priority::stop ? stop_patience : taking_patience);
  auto put = co_await put_text(text, priority);
  while (put && !*put && scheduler_.now() < give_up) {
    auto paused = co_await pause(ring_look);
    if (!paused) co_return paused;
    put = co_await put_text(text, priority);
  }
  if (!put) co_return fail(put.error());
  const int begin = advanced(put_, -static_cast<int>(text.size()));  // of what was put
  bool taken = false;
  while (*put && !taken) {
    const auto looked = co_await is_taken(priority);
    if (!looked) co_return fail(looked.error());
    taken = *looked;
    if (taken || scheduler_.now() >= give_up) break;
    auto paused = co_await pause(ring_look);
    if (!paused) co_return paused;
  }
  if (taken) co_return Result<>();
  const bool waits = *put && when_stuck == WhenStuck::leave;
  if (*put && !waits) {
    auto withdrawn = co_await withdraw_text(priority, begin);
    if (!withdrawn) co_return withdrawn;
  }
  co_return fail(FaultKind::no_answer,
                 "The board takes no command now: a command queue is full, or it waits in WQ.",
                 waits ? "What was sent waits in the ring and will be carried out when there is room."
                       : "What was sent was taken back.",
                 "Wait until its queues have room, or stop it.");
}

Task<Result<>> Vme58Driver::command(std::string text, Priority priority) {
  auto settled = co_await settle_late_rejection(priority);
  if (!settled) co_return settled;
  const int put_before = put_;
  auto written = co_await write(text, priority);
  if (!written) co_return fail(put_ == put_before ? written.error() : when_put(written.error()));
  const auto bad = co_await was_rejected(priority);
  if (!bad) co_return fail(when_put(bad.error()));
  if (*bad) co_return rejected(text);
  co_return Result<>();
}

// ---- replies

Task<Result<std::vector<std::string>>> Vme58Driver::ask_several(std::string text, std::size_t count,
                                                                Priority priority, Duration patience) {
  auto clear = co_await let_owed_replies_go(priority);
  if (!clear) co_return fail(clear.error());
  const Instant asked_at = scheduler_.now();
  const int put_before = put_;
  std::vector<std::string> replies;
  auto asked = co_await write(text, priority);
  const bool comes = asked || (asked.error().kind == FaultKind::stopped && put_ != put_before);
  if (asked) asked = co_await collect(replies, count, priority, asked_at + patience, text);
  if (!asked) {
    if (comes && asked.error().kind != FaultKind::controller) replies_owed_ += count - replies.size();
    co_return fail(asked.error());
  }
  station_->count_answer(scheduler_.now() - asked_at, priority == Priority::poll, scheduler_.now());
  co_return replies;
}

Task<Result<>> Vme58Driver::collect(std::vector<std::string>& replies, std::size_t count, Priority priority,
                                    Instant give_up, std::string_view question) {
  for (;;) {
    const auto put = co_await read_index(at::input_put_index, priority);
    if (!put) co_return fail(put.error());
    auto fetched = co_await fetch_replies(*put, priority);
    if (!fetched) co_return fetched;
    while (!replies_.empty() && replies.size() < count) {
      record(Way::received, priority, replies_.front());
      replies.push_back(std::move(replies_.front()));
      replies_.pop_front();
    }
    if (replies.size() == count) co_return Result<>();
    if (scheduler_.now() > give_up) break;
    auto paused = co_await pause(ring_look);
    if (!paused) co_return paused;
  }
  const auto bad = co_await was_rejected(priority);
  if (bad && *bad) co_return rejected(question);
  if (station_) station_->count_miss();
  co_return fail(FaultKind::no_answer,
                 fmt::format("The board did not answer to {} in time.", without_end(question)));
}

/// What is asked next must not be answered by a reply to a question that a stop has cut short. The board has
/// replied to all that it has taken from the ring.
Task<Result<>> Vme58Driver::let_owed_replies_go(Priority priority) {
  if (replies_owed_ > 0) {
    const Instant give_up = scheduler_.now() + taking_patience;
    auto taken = co_await is_taken(priority);
    while (taken && !*taken && scheduler_.now() < give_up) {
      auto paused = co_await pause(ring_look);
      if (!paused) co_return paused;
      taken = co_await is_taken(priority);
    }
    if (!taken) co_return fail(taken.error());
    if (!*taken)
      co_return fail(FaultKind::no_answer, "The board has not come to an earlier question yet.",
                     "Nothing was sent.");
    auto put = co_await read_index(at::input_put_index, priority);
    if (!put) co_return fail(put.error());
    auto fetched = co_await fetch_replies(*put, priority);
    if (!fetched) co_return fetched;
  }
  give_unsolicited();
  replies_owed_ = 0;
  co_return Result<>();
}

Task<Result<std::string>> Vme58Driver::ask(std::string question, Priority priority, Duration patience) {
  auto replies = co_await ask_several(std::move(question), 1, priority, patience);
  if (!replies) co_return fail(replies.error());
  co_return std::move(replies->front());
}

Task<Result<>> Vme58Driver::fetch_replies(int input_put, Priority priority) {
  const int count = waiting(input_put, get_);
  if (count == 0) co_return Result<>();
  std::vector<BusCycle>& cycles = burst();
  append_reply_reads(cycles, get_, count);
  cycles.push_back(BusCycle::store(2, at::input_get_index, static_cast<std::uint32_t>(input_put)));
  auto done = co_await run(cycles, priority);
  if (!done) co_return done;
  cycles.pop_back();
  get_ = input_put;
  received_ += reply_text(cycles);
  while (auto reply = take_reply(received_, echo_)) replies_.push_back(std::move(*reply));
  co_return Result<>();
}

// What nobody waits for: replies to raw text, and to questions that were given up.
void Vme58Driver::give_unsolicited() {
  for (; !replies_.empty(); replies_.pop_front()) {
    if (replies_owed_ > 0) {
      --replies_owed_;
      continue;
    }
    if (station_)
      station_->record(scheduler_.now(), Way::received, TrafficKind::unsolicited, replies_.front());
    texts_.add(std::move(replies_.front()));
  }
}

// ---- small

/// `selector` and what it is to hear, then back to the axis that the user's own text speaks to.
/// The console counts in counts: user units are put aside for its own text (they act when a command is read).
std::string Vme58Driver::addressed(std::string_view selector, std::string_view text) const {
  const std::string back = context_.selector();
  const bool group = selector == "AA" || selector == "AM";
  std::string units;
  for (int i = 0; i < axis_count(); ++i) {
    if (!group && selector.back() != axis_name(i).back()) continue;
    if (group && i > 0) units += ',';
    if (user_unit_[ix(i)] != 0) units += fmt::format("{}", user_unit_[ix(i)]);
  }
  const bool set_aside = units.find_first_not_of(',') != units.npos;
  std::string all = fmt::format("{} {}{}", selector, set_aside ? "UF " : "", text);
  if (set_aside) all += fmt::format(" UU{};", units);
  if (back != selector) all += " " + back;
  return all + "\n";
}
std::string Vme58Driver::addressed(int axis, std::string_view text) const {
  return addressed("A" + axis_name(axis), text);
}

void Vme58Driver::record(Way way, Priority priority, std::string_view text) {
  if (!station_) return;
  while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  station_->record(scheduler_.now(), way, kind_of(priority), text);
}

void Vme58Driver::tell(Notice::Kind kind, std::string text) {
  if (notify_) notify_(Notice(kind, scheduler_.now(), std::move(text)));
}

}  // namespace hw::vme58
