#include "core/link/station.h"

#include "core/link/link_log.h"

namespace hw {
namespace {

Fault no_connection() {
  return Fault(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
}

Task<Result<std::string>> not_sent(Fault why) { co_return fail(std::move(why)); }
Task<Result<>> not_run(Fault why) { co_return fail(std::move(why)); }
Task<Result<>> nothing_to_do() { co_return Result<>(); }

}  // namespace

Station::Station(std::shared_ptr<Link> link, TrafficRing* traffic)
    : link_(std::move(link)), traffic_(traffic), ended_(link_->scheduler_) {
  link_->join(*this);
}

Station::~Station() { close(Fault(FaultKind::lost, "The connection was closed.")); }

Task<Result<std::string>> Station::transact(Transaction transaction) {
  const bool is_stop = transaction.priority == Priority::stop && !transaction.own_question;
  if (preempted_ || is_stop || transaction.on_dirty_line || !unmistakable || !is_dirty())
    return send(std::move(transaction));
  return transact_when_clean(std::move(transaction));
}

// A stop, or the end of the wire, may have come since.
Task<Result<std::string>> Station::send(Transaction transaction) {
  if (!link_) return not_sent(no_connection());
  if (preempted_) return not_sent(stop_came_first());
  return link_->transact(*this, std::move(transaction));
}

Task<Result<>> Station::bus(std::span<BusCycle> cycles, Priority priority) {
  if (!link_) return not_run(no_connection());
  if (preempted_) return not_run(stop_came_first());
  return link_->run(*this, cycles, priority);
}

void Station::preempt() {
  if (uncut_ > 0) {
    preempt_due_ = true;
    link_log().debug("{}a stop waits for commands that must not be cut", OfDevice{address});
    return;
  }
  preempted_ = true;
  if (link_) {
    link_->drop_waiting(*this, stop_came_first());
    link_->shorten_for_stop();
  }
  ended_.notify();
  if (procedure_ended) procedure_ended();
}

void Station::stop_was_sent() {
  if (link_) link_->start_next();
}

Task<Result<>> Station::pause(Duration time) {
  if (!link_) co_return fail(no_connection());
  if (preempted_) co_return fail(stop_came_first());
  co_await ended_.wait_until(link_->scheduler_.now() + time);
  if (preempted_) co_return fail(stop_came_first());
  if (!link_) co_return fail(no_connection());
  co_return Result<>();
}

// ---- the dirty line

bool Station::is_dirty() const {
  return link_ && !outstanding_.never() && outstanding_.any(link_->scheduler_.now());
}
bool Station::others_outstanding(ReplyKind reply_kind) const {
  return link_ && link_->outstanding_by_others(*this, reply_kind);
}

void Station::doubt(ReplyKind reply_kind) {
  if (!link_) return;
  link_log().debug("{}a reply that is no longer awaited may still come", OfDevice{address});
  outstanding_.add(reply_kind, link_->scheduler_.now());
}

Task<Result<>> Station::clean_line(Priority priority) {
  if (!link_) return not_run(no_connection());
  if (preempted_) return not_run(stop_came_first());
  if (!unmistakable || !is_dirty()) return nothing_to_do();
  return clean(priority);
}

Task<Result<std::string>> Station::transact_when_clean(Transaction transaction) {
  const Priority priority = transaction.priority;
  auto cleaned = co_await clean(priority);
  if (!cleaned) co_return fail(cleaned.error());
  co_return co_await send(std::move(transaction));
}

// No question is repeated on a dirty line: each attempt asks another one and waits longer.
Task<Result<>> Station::clean(Priority priority) {
  while (is_dirty()) {
    auto asked = unmistakable(outstanding_, link_->scheduler_.now());
    Result<> step;
    if (asked)
      step = co_await clean_by(std::move(*asked), priority);
    else
      step = co_await outwait(priority);
    if (!step) co_return step;
  }
  co_return Result<>();
}

/// Waits until one of the outstanding replies can no longer come. A stop is repeated meanwhile.
Task<Result<>> Station::outwait(Priority priority) {
  if (priority == Priority::stop) {
    count_miss();
    co_return fail(FaultKind::no_answer, "The controller did not answer in time.");
  }
  co_return co_await pause(outstanding_.next_end(link_->scheduler_.now()) - link_->scheduler_.now());
}

Task<Result<>> Station::clean_by(Unmistakable asked, Priority priority) {
  constexpr Duration first_patience = Millis(600);
  constexpr Duration patience_of_a_stop = Millis(250);  // then the stop is repeated
  auto silent = co_await wait_for_silence();
  if (!silent) co_return silent;
  Transaction question = std::move(asked.question);
  const ReplyKind reply_kind = question.reply_kind;
  const bool may_be_silent = question.may_be_silent && priority != Priority::stop;
  question.may_be_silent = may_be_silent;
  question.priority = priority;
  question.own_question = true;
  question.on_dirty_line = true;
  const bool soon = may_be_silent || statistics_.misses_in_a_row < 2;
  question.patience = priority == Priority::stop ? patience_of_a_stop
                      : soon                     ? first_patience
                                                 : OutstandingReplies::longest_delay;
  auto answer = co_await send(std::move(question));
  if (!answer && answer.error().kind == FaultKind::no_answer && may_be_silent) {
    doubt(reply_kind);
    co_return Result<>();
  }
  if (!answer) co_return fail(answer.error());
  if (!asked.is_answer(*answer)) {  // not a miss: a device answered
    link_log().debug("{}not the reply to the query: \"{}\"", OfDevice{address}, log::Bytes{*answer});
    doubt(reply_kind);
    co_return fail(FaultKind::garbled, "The controller's reply is not understood.", "The reply was not used.",
                   "Check the cable and the baud rate. Check whether two devices have the same address, or "
                   "another program uses this line.");
  }
  outstanding_.clear();
  link_log().debug("{}the line is clean: cleaned {} times", OfDevice{address}, times_cleaned_ + 1);
  ++times_cleaned_;
  learn_lateness(statistics_.last_round_trip);
  co_return Result<>();
}

Task<Result<>> Station::wait_for_silence() {
  constexpr Duration long_enough = Millis(50), at_most = std::chrono::seconds(1);
  const Instant began = link_->scheduler_.now();
  Duration left = long_enough;
  while (left > Duration::zero()) {
    auto waited = co_await pause(left);
    if (!waited) co_return waited;
    const Instant now = link_->scheduler_.now();
    left = std::max(began, received_at_) + long_enough - now;
    if (left <= Duration::zero() || now - began < at_most) continue;
    count_miss();
    link_log().debug("{}the line has not been silent for {} ms within a second", OfDevice{address},
                     long_enough / Millis(1));
    co_return fail(FaultKind::garbled, "The line is never silent.", "Nothing was sent.",
                   "Check the cable, the baud rate, and whether another program talks to the controller.");
  }
  co_return Result<>();
}

// A reply after the usual patience shows how slow this device is. Decays as replies come faster.
void Station::learn_lateness(Duration round_trip) {
  constexpr Duration usual = Millis(100);
  const Duration before = lateness_;
  if (round_trip >= lateness_)
    lateness_ = round_trip > usual ? round_trip : Duration::zero();
  else if (lateness_ = (lateness_ + round_trip) / 2; lateness_ < usual)
    lateness_ = Duration::zero();
  if ((before == Duration::zero()) != (lateness_ == Duration::zero()))
    link_log().debug("{}waits {} ms longer than usual for replies", OfDevice{address}, lateness_ / Millis(1));
}

Result<> Station::set_rate(int baud) {
  if (!link_) return fail(no_connection());
  if (!link_->stream_) return {};
  auto set = link_->stream_->set_rate(baud);
  link_log().debug("{}rate {} baud: {}", OfDevice{address}, baud, set ? "set" : set.error().what);
  if (set && link_->rate() > 0 && link_->rate_set) link_->rate_set(baud);
  return set;
}

void Station::close(const Fault& why) { leave(why, Link::Leaving::in_order); }

void Station::give_up(const Fault& why) { leave(why, Link::Leaving::given_up); }

void Station::leave(const Fault& why, Link::Leaving how) {
  const auto link = std::exchange(link_, nullptr);
  if (!link) return;
  link->leave(*this, why, how);
  ended_.notify();
  if (procedure_ended) procedure_ended();
}

void Station::record(Instant at, Way way, TrafficKind kind, std::string_view bytes) {
  if (!traffic_) return;
  // However much a controller babbles, stops and intents keep their places in the record.
  const bool of_user = way == Way::sent && (kind == TrafficKind::stop || kind == TrafficKind::intent);
  const std::size_t left_for_others = of_user ? 0 : traffic_->capacity() / 4;
  do {  // a slot of the ring keeps its memory: no piece is longer than this
    const std::string_view piece = bytes.substr(0, longest_traffic_entry);
    bytes.remove_prefix(piece.size());
    const auto fill = [&](TrafficEntry& entry) {
      entry.at = at;
      entry.way = way;
      entry.kind = kind;
      entry.bytes = piece;
    };
    traffic_->push_in_place(fill, left_for_others);
  } while (!bytes.empty());
  if (kind != TrafficKind::poll && recorded) recorded();
}

void Station::count(const Result<std::string>& result, bool question, bool poll, Duration round_trip,
                    Instant now) {
  ++statistics_.transactions;
  if (result && question) {
    statistics_.last_round_trip = round_trip;
    statistics_.misses_in_a_row = 0;
    if (poll) ++polls_counted_;
    if (lateness_ > Duration::zero()) learn_lateness(round_trip);
  }
  count_polls(now);
}

void Station::count_burst(bool done) {
  ++statistics_.transactions;
  if (!done) count_miss();
}

void Station::count_answer(Duration round_trip, bool poll, Instant now) {
  statistics_.last_round_trip = round_trip;
  statistics_.misses_in_a_row = 0;
  if (poll) ++polls_counted_;
  count_polls(now);
}

void Station::count_miss() {
  ++statistics_.timeouts;
  ++statistics_.misses_in_a_row;
}

void Station::count_polls(Instant now) {
  constexpr auto long_enough = std::chrono::seconds(2);  // so that one round more or less matters little
  if (now - count_began_ >= long_enough) {
    statistics_.polls_per_second = polls_counted_ / seconds(now - count_began_);
    polls_counted_ = 0;
    count_began_ = now;
  }
}

}  // namespace hw
