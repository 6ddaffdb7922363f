#include "core/link/link.h"

#include <algorithm>

namespace hw {

// One transaction, waiting or in flight. It lives in the frame of the coroutine that waits for it.
struct Link::Pending {
  Transaction transaction;
  Result<std::string> result{std::string()};
  Suspended suspended;
  bool finished = false;
  explicit Pending(Transaction t) : transaction(std::move(t)) {}
};

static TrafficKind kind_of(Priority p) {
  switch (p) {
    case Priority::stop: return TrafficKind::stop;
    case Priority::intent: return TrafficKind::intent;
    case Priority::transfer: return TrafficKind::transfer;
    case Priority::poll: return TrafficKind::poll;
  }
  return TrafficKind::intent;
}

static bool yields_to_stop(Priority p) { return p == Priority::intent || p == Priority::transfer; }
static tl::unexpected<Fault> overtaken() {
  return fail(FaultKind::stopped, "A stop came first.", "This was not sent.");
}

Link::Link(Scheduler& scheduler, std::unique_ptr<Stream> stream, TrafficRing* traffic)
    : scheduler_(scheduler),
      stream_(std::move(stream)),
      traffic_(traffic),
      deadline_(scheduler, [this] { on_deadline(); }),
      settled_(scheduler, [this] { start_next(); }),
      second_began_(scheduler.now()) {
  stream_->listen(this);
}

Link::~Link() {
  if (open_) close(Fault(FaultKind::lost, "The connection was closed."));
}

Duration Link::wire_time(std::size_t bytes) const {
  const int rate = stream_->rate();
  return rate > 0 ? Duration(static_cast<Duration::rep>(bytes * 10'000'000'000ULL / rate)) : Duration::zero();
}

Task<Result<std::string>> Link::transact(Transaction transaction) {
  if (!open_)
    co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
  if (stopping_ && yields_to_stop(transaction.priority)) co_return overtaken();
  Pending pending(std::move(transaction));
  waiting_[static_cast<std::size_t>(pending.transaction.priority)].push_back(&pending);
  start_next();
  while (!pending.finished) co_await pending.suspended.here();
  co_return std::move(pending.result);
}

void Link::start_next() {
  if (in_flight_ || !open_) return;
  const bool settling = scheduler_.now() < settle_until_;
  for (auto& queue : waiting_) {
    if (queue.empty()) continue;
    if (settling && queue.front()->transaction.priority != Priority::stop) {
      settled_.arm(settle_until_);
      return;
    }
    in_flight_ = queue.front();
    queue.pop_front();
    break;
  }
  if (!in_flight_) return;
  const Transaction& t = in_flight_->transaction;
  sent_at_ = scheduler_.now();
  statistics_.bytes_sent += t.bytes.size();
  record(Way::sent, kind_of(t.priority), t.bytes);
  if (t.reply.kind == ReplyShape::Kind::none) {
    stream_->send(t.bytes);
    // It stays in flight while it is on the wire: what comes next, a stop perhaps, must not stand in a queue
    // of the port's, where nothing overtakes.
    const Duration on_wire = wire_time(t.bytes.size());
    if (on_wire == Duration::zero()) return finish(std::string());
    deadline_.arm(sent_at_ + on_wire);
    return;
  }
  constexpr std::size_t usual_answer = 16;
  deadline_.arm(sent_at_ + t.patience + wire_time(t.bytes.size() + usual_answer));
  stream_->send(t.bytes);
}

void Link::finish(Result<std::string> result) {
  Pending* done = std::exchange(in_flight_, nullptr);
  deadline_.disarm();
  ++statistics_.transactions;
  const Instant now = scheduler_.now();
  if (result && done->transaction.reply.kind != ReplyShape::Kind::none) {
    statistics_.last_round_trip = now - sent_at_;
    statistics_.misses_in_a_row = 0;
    if (done->transaction.priority == Priority::poll) ++polls_this_second_;
  }
  if (now - second_began_ >= std::chrono::seconds(1)) {
    statistics_.polls_per_second = polls_this_second_ / seconds(now - second_began_);
    polls_this_second_ = 0;
    second_began_ = now;
  }
  done->result = std::move(result);
  done->finished = true;
  done->suspended.resume(scheduler_.executor());
  start_next();
}

void Link::on_deadline() {
  if (!in_flight_) return;
  if (in_flight_->transaction.reply.kind == ReplyShape::Kind::none) return finish(std::string());
  if (in_flight_->transaction.reply.kind == ReplyShape::Kind::quiet_end && !received_.empty()) {
    finish(std::exchange(received_, {}));
    return;
  }
  ++statistics_.timeouts;
  ++statistics_.misses_in_a_row;
  settle_until_ = scheduler_.now() + settle_time;
  Fault fault(received_.empty() ? FaultKind::no_answer : FaultKind::garbled,
              received_.empty() ? "The controller did not answer in time."
                                : "The controller's answer stopped in the middle.");
  if (!received_.empty()) {
    statistics_.unparsed_bytes += received_.size();
    record(Way::received, TrafficKind::unparsed, received_);
    received_.clear();
  }
  finish(fail(std::move(fault)));
}

void Link::bytes_arrived(std::string_view bytes) {
  statistics_.bytes_received += bytes.size();
  received_.append(bytes);
  take_received();
}

// False: what came in cannot be told from a reply yet.
bool Link::strip_strangers() {
  const auto stranger = in_flight_->transaction.stranger;
  if (!stranger) return true;
  std::size_t length = 0, next = 0;
  while (length < received_.size() && (next = stranger(std::string_view(received_).substr(length))) > 0) {
    if (next == std::string_view::npos) break;
    length += next;
  }
  if (length > 0) {
    const std::string strangers = received_.substr(0, length);
    received_.erase(0, length);
    give_unsolicited(strangers);
  }
  return next != std::string_view::npos;
}

void Link::take_received() {
  while (!received_.empty()) {
    if (!in_flight_ || in_flight_->transaction.reply.kind == ReplyShape::Kind::none) {
      give_unsolicited(std::exchange(received_, {}));
      return;
    }
    if (!strip_strangers()) return;
    if (!in_flight_ || received_.empty()) continue;
    const Transaction& t = in_flight_->transaction;
    if (t.reply.kind == ReplyShape::Kind::quiet_end) {
      deadline_.arm(scheduler_.now() + Millis(t.reply.quiet_ms) + wire_time(2));
      return;
    }
    const auto length = t.reply.complete(received_);
    if (!length) return;
    std::string reply = received_.substr(0, *length);
    received_.erase(0, *length);
    record(Way::received, kind_of(t.priority), reply);
    finish(std::move(reply));
  }
}

void Link::give_unsolicited(std::string_view bytes) {
  const std::size_t understood = unsolicited ? std::min(unsolicited(bytes), bytes.size()) : 0;
  if (understood > 0) record(Way::received, TrafficKind::unsolicited, bytes.substr(0, understood));
  if (understood < bytes.size()) {
    statistics_.unparsed_bytes += bytes.size() - understood;
    record(Way::received, TrafficKind::unparsed, bytes.substr(understood));
  }
}

void Link::record(Way way, TrafficKind kind, std::string_view bytes) {
  if (!traffic_) return;
  TrafficEntry entry;
  entry.at = scheduler_.now();
  entry.way = way;
  entry.kind = kind;
  entry.bytes = bytes;
  traffic_->push(std::move(entry));
}

void Link::begin_stop() {
  stopping_ = true;
  for (const Priority priority : {Priority::intent, Priority::transfer})
    for (Pending* p : std::exchange(waiting_[static_cast<std::size_t>(priority)], {})) {
      p->result = overtaken();
      p->finished = true;
      p->suspended.resume(scheduler_.executor());
    }
}

void Link::close(const Fault& why) {
  if (!open_) return;
  open_ = false;
  deadline_.disarm();
  settled_.disarm();
  stream_->listen(nullptr);
  const auto end = [&](Pending* p) {
    p->result = fail(FaultKind::lost, why.what, why.done, why.advice);
    p->finished = true;
    p->suspended.resume(scheduler_.executor());
  };
  if (in_flight_) end(std::exchange(in_flight_, nullptr));
  for (auto& queue : waiting_)
    for (Pending* p : std::exchange(queue, {})) end(p);
}

void Link::stream_closed(const Fault& why) {
  close(why);
  if (closed) closed(why);
}

}  // namespace hw
