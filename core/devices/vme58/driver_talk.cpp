// The rings: commands in, replies out.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr std::size_t most_for_scripts = 256;
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

tl::unexpected<Fault> Vme58Driver::no_connection() const {
  return fail(FaultKind::lost, "There is no connection to the board.", "Nothing was sent.");
}

Task<Result<>> Vme58Driver::run(std::vector<BusCycle>& cycles, Priority priority) {
  if (!station_) co_return no_connection();
  co_return co_await station_->bus(cycles, priority);
}

// Read twice: while the board moves it, or when a byte was garbled, the two differ.
Task<Result<int>> Vme58Driver::read_index(std::uint16_t offset, Priority priority) {
  Burst burst(*this);
  std::vector<BusCycle>& cycles = burst.cycles;
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
  while (writing_) co_await written_.wait();
  struct Writing {
    Vme58Driver& driver;
    explicit Writing(Vme58Driver& d) : driver(d) { driver.writing_ = true; }
    ~Writing() {
      driver.writing_ = false;
      driver.written_.notify();
    }
  } writing(*this);
  const auto get = co_await read_index(at::output_get_index, priority);
  if (!get) co_return fail(get.error());
  if (room(put_, *get) < static_cast<int>(text.size())) co_return false;
  Burst burst(*this);
  std::vector<BusCycle>& cycles = burst.cycles;
  // Where a stranger has spoiled the host's other index the board takes nothing.
  cycles.push_back(BusCycle::store(2, at::input_get_index, static_cast<std::uint32_t>(get_)));
  append_text(cycles, text, put_);
  on_its_way_ = true;
  in_wq_ = in_wq_ || text.find("WQ") != text.npos;
  auto done = co_await run(cycles, priority);
  if (!done) co_return fail(done.error());
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
  Burst burst(*this);
  std::vector<BusCycle>& cycles = burst.cycles;
  for (int i = begin; i != put_; i = advanced(i, 1))
    cycles.push_back(BusCycle::store(2, static_cast<std::uint16_t>(at::output_buffer + 2 * i), ' '));
  if (cycles.empty()) co_return Result<>();
  selection_lost_ = true;
  co_return co_await run(cycles, priority);
}

/// The board stands at the axis that the user's text has selected, also after text was taken back.
Task<Result<>> Vme58Driver::select_again(Priority priority) {
  if (!selection_lost_ || context_.recording) co_return Result<>();
  std::string selector = context_.selector() + "\n";
  auto written = co_await write(selector, priority);
  if (written && selector == context_.selector() + "\n") selection_lost_ = false;  // else a stop has selected
  co_return written;
}

/// Returns when the board has taken it. Text that would wait behind a full queue and act at an unexpected
/// time is taken back, unless it may wait.
Task<Result<>> Vme58Driver::write(std::string text, Priority priority, WhenStuck when_stuck) {
  const Instant give_up = scheduler_.now() + (priority == Priority::stop ? stop_patience : taking_patience);
  auto put = co_await put_text(text, priority);
  while (put && !*put && scheduler_.now() < give_up) {
    co_await scheduler_.sleep_for(ring_look);
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
    co_await scheduler_.sleep_for(ring_look);
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
  auto written = co_await write(text, priority);
  if (!written) co_return written;
  const auto bad = co_await was_rejected(priority);
  if (!bad) co_return fail(bad.error());
  if (*bad) co_return rejected(text);
  co_return Result<>();
}

// ---- replies

Task<Result<std::vector<std::string>>> Vme58Driver::ask_several(std::string text, std::size_t count,
                                                                Priority priority, Duration patience) {
  give_unsolicited();
  struct Wanting {
    Vme58Driver& driver;
    Wanting(Vme58Driver& d, std::size_t n) : driver(d) { driver.replies_wanted_ = n; }
    ~Wanting() { driver.replies_wanted_ = 0; }
  } wanting(*this, count);
  const Instant asked_at = scheduler_.now();
  auto written = co_await write(text, priority);
  if (!written) co_return fail(written.error());
  std::vector<std::string> replies;
  while (true) {
    const auto put = co_await read_index(at::input_put_index, priority);
    if (!put) co_return fail(put.error());
    auto fetched = co_await fetch_replies(*put, priority);
    if (!fetched) co_return fail(fetched.error());
    while (!replies_.empty() && replies.size() < count) {
      record(Way::received, priority, replies_.front());
      replies.push_back(std::move(replies_.front()));
      replies_.pop_front();
    }
    if (replies.size() == count) break;
    if (scheduler_.now() - asked_at > patience) {
      const auto bad = co_await was_rejected(priority);
      if (bad && *bad) co_return rejected(text);
      if (station_) station_->count_miss();
      co_return fail(FaultKind::no_answer,
                     fmt::format("The board did not answer to {} in time.", without_end(text)));
    }
    co_await scheduler_.sleep_for(ring_look);
  }
  station_->count_answer(scheduler_.now() - asked_at, priority == Priority::poll, scheduler_.now());
  co_return replies;
}

Task<Result<std::string>> Vme58Driver::ask(std::string question, Priority priority, Duration patience) {
  auto replies = co_await ask_several(std::move(question), 1, priority, patience);
  if (!replies) co_return fail(replies.error());
  co_return std::move(replies->front());
}

Task<Result<>> Vme58Driver::fetch_replies(int input_put, Priority priority) {
  const int count = waiting(input_put, get_);
  if (count == 0) co_return Result<>();
  Burst burst(*this);
  std::vector<BusCycle>& cycles = burst.cycles;
  append_reply_reads(cycles, get_, count);
  cycles.push_back(BusCycle::store(2, at::input_get_index, static_cast<std::uint32_t>(input_put)));
  auto done = co_await run(cycles, priority);
  if (!done) co_return done;
  cycles.pop_back();
  get_ = input_put;
  received_ += reply_text(cycles);
  while (auto reply = take_reply(received_, echo_)) replies_.push_back(std::move(*reply));
  if (replies_wanted_ == 0) give_unsolicited();
  co_return Result<>();
}

// What nobody waits for: replies to raw text.
void Vme58Driver::give_unsolicited() {
  while (!replies_.empty()) {
    if (station_)
      station_->record(scheduler_.now(), Way::received, TrafficKind::unsolicited, replies_.front());
    for_scripts(std::move(replies_.front()));
    replies_.pop_front();
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

void Vme58Driver::for_scripts(std::string text) {
  if (for_scripts_.size() >= most_for_scripts) for_scripts_.pop_front();
  for_scripts_.push_back(std::move(text));
}

bool Vme58Driver::take_unsolicited(std::string& text) {
  if (for_scripts_.empty()) return false;
  text = std::move(for_scripts_.front());
  for_scripts_.pop_front();
  return true;
}

void Vme58Driver::tell(Notice::Kind kind, std::string text) {
  if (notify_) notify_(Notice(kind, scheduler_.now(), std::move(text)));
}

}  // namespace hw::vme58
