#include "core/link/station.h"

namespace hw {
namespace {

Fault no_connection() {
  return Fault(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
}

Task<Result<std::string>> not_sent(Fault why) { co_return fail(std::move(why)); }
Task<Result<>> not_run(Fault why) { co_return fail(std::move(why)); }

}  // namespace

Station::Station(std::shared_ptr<Link> link, TrafficRing* traffic)
    : link_(std::move(link)), traffic_(traffic), ended_(link_->scheduler_) {
  link_->join(*this);
}

Station::~Station() { close(Fault(FaultKind::lost, "The connection was closed.")); }

Task<Result<std::string>> Station::transact(Transaction transaction) {
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
    return;
  }
  preempted_ = true;
  if (link_) {
    link_->drop_waiting(*this, stop_came_first());
    link_->hurry_for_a_stop();
  }
  ended_.notify();
  if (procedure_ended) procedure_ended();
}

Task<Result<>> Station::pause(Duration time) {
  if (!link_) co_return fail(no_connection());
  if (preempted_) co_return fail(stop_came_first());
  const bool ended = co_await ended_.wait_until(link_->scheduler_.now() + time);
  if (!ended) co_return Result<>();
  co_return fail(preempted_ ? stop_came_first() : no_connection());
}

bool Station::owes_answer() const { return link_ && link_->scheduler_.now() < owes_until_; }
bool Station::answer_owed_on_wire() const { return link_ && link_->answer_owed(); }

Result<> Station::set_rate(int baud) {
  if (!link_) return fail(no_connection());
  if (!link_->stream_) return {};
  auto set = link_->stream_->set_rate(baud);
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
  do {  // a slot of the ring keeps its memory: no piece is longer than this
    const std::string_view piece = bytes.substr(0, longest_traffic_entry);
    bytes.remove_prefix(piece.size());
    traffic_->push_in_place([&](TrafficEntry& entry) {
      entry.at = at;
      entry.way = way;
      entry.kind = kind;
      entry.bytes = piece;
    });
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
  constexpr auto long_enough = std::chrono::seconds(2);  // that a round more or less makes little difference
  if (now - count_began_ >= long_enough) {
    statistics_.polls_per_second = polls_counted_ / seconds(now - count_began_);
    polls_counted_ = 0;
    count_began_ = now;
  }
}

}  // namespace hw
