#include "core/link/link.h"

#include <algorithm>

#include "core/link/link_log.h"
#include "core/link/pending.h"
#include "core/link/station.h"

namespace hw {

Fault stop_came_first() {
  return Fault(FaultKind::stopped, "A stop came first.", "The command was not sent.");
}

static TrafficKind traffic_kind(const Transaction& t) {
  if (t.own_question) return TrafficKind::poll;
  switch (t.priority) {
    case Priority::stop: return TrafficKind::stop;
    case Priority::intent: return TrafficKind::intent;
    case Priority::transfer: return TrafficKind::transfer;
    case Priority::poll: return TrafficKind::poll;
  }
  return TrafficKind::intent;
}

Link::Link(Scheduler& scheduler, std::unique_ptr<Stream> stream)
    : scheduler_(scheduler),
      stream_(std::move(stream)),
      deadline_(scheduler, [this] { on_deadline(); }),
      settled_(scheduler, [this] { start_next(); }),
      unfinished_(scheduler, [this] { give_up_waiting(); }) {
  stream_->listen(this);
}

Link::Link(Scheduler& scheduler, std::unique_ptr<Window> window)
    : scheduler_(scheduler),
      window_(std::move(window)),
      deadline_(scheduler, [] {}),
      settled_(scheduler, [] {}),
      unfinished_(scheduler, [] {}) {
  window_->listen(this);
}

Link::~Link() {
  if (stream_) stream_->listen(nullptr);
  if (window_) window_->listen(nullptr);
}

void Link::join(Station& station) {
  station.count_began_ = scheduler_.now();
  stations_.push_back(&station);
}

Duration Link::wire_time(std::size_t bytes) const {
  const int baud = rate();
  return baud > 0 ? Duration(static_cast<Duration::rep>(bytes * 10'000'000'000ULL / baud)) : Duration::zero();
}

// ---- what goes out

Task<Result<std::string>> Link::transact(Station& station, Transaction transaction) {
  Pending pending(station, std::move(transaction));
  waiting_[static_cast<std::size_t>(pending.transaction.priority)].push_back(&pending);
  if (pending.transaction.priority == Priority::stop) shorten_for_stop();
  start_next();
  while (!pending.finished) co_await pending.suspended.here();
  co_return std::move(pending.result);
}

// A stop waits no longer than for a usual reply, whatever the patience of the question in flight. A reply
// that is coming in is received to its end.
void Link::shorten_for_stop() {
  constexpr std::size_t usual_answer = 16;
  if (!in_flight_ || !stream_ || !in_flight_->is_question()) return;
  if (in_flight_->transaction.reply.kind == ReplyShape::Kind::quiet_end && !received_.empty()) return;
  const Duration on_wire = wire_time(in_flight_->transaction.bytes.size() + usual_answer);
  const Instant latest = std::max(scheduler_.now(), sent_at_ + on_wire) + longest_wait_of_a_stop;
  latest_end_ = std::min(latest_end_, latest);
  if (latest_end_ >= deadline_at_) return;
  link_log().debug("a stop waits: the answer to \"{}\" is waited for {:.0f} ms more, not {:.0f} ms",
                   log::Bytes{in_flight_->transaction.bytes}, 1e3 * seconds(latest_end_ - scheduler_.now()),
                   1e3 * seconds(deadline_at_ - scheduler_.now()));
  deadline_.arm(deadline_at_ = latest_end_);
}

// A window has a deadline of its own, so that a burst under way always ends.
Task<Result<>> Link::run(Station& station, std::span<BusCycle> cycles, Priority priority) {
  const auto keep = shared_from_this();
  Pending pending(station, Transaction({}, ReplyShape::nothing(), priority));
  waiting_[static_cast<std::size_t>(priority)].push_back(&pending);
  start_next();
  while (!pending.its_turn && !pending.finished) co_await pending.suspended.here();
  if (!pending.finished) {
    const auto window = window_;
    auto done = co_await window->run(cycles);
    if (!pending.finished && done) finish(std::string());
    if (!pending.finished && !done) finish(fail(done.error()));
  }
  if (!pending.result) co_return fail(pending.result.error());
  co_return Result<>();
}

/// While a station stops its device, the others' questions wait; their stops do not.
bool Link::may_go_out(const Pending& pending) const {
  const auto stops = [](const Station* s) { return s->stops && s->stops(); };
  return pending.transaction.priority == Priority::stop || stops(&pending.station) ||
         std::none_of(stations_.begin(), stations_.end(), stops);
}

bool Link::nothing_waits() const {
  return std::all_of(waiting_.begin(), waiting_.end(), [](const auto& queue) { return queue.empty(); });
}

void Link::start_next() {
  if (in_flight_ || !is_open() || nothing_waits()) return;
  if (wills_.may_be_carried_out())
    return give_up_soon(Fault(FaultKind::lost,
                              "This program was suspended for about a second while a jog was held.",
                              "The watchdog has stopped the jog."));
  const Instant now = scheduler_.now();
  const bool settling = stream_ && now < settle_until_;
  for (auto& queue : waiting_) {
    const auto next =
        std::find_if(queue.begin(), queue.end(), [this](const Pending* p) { return may_go_out(*p); });
    if (next == queue.end()) continue;
    if (settling && (*next)->transaction.priority != Priority::stop) {
      settled_.arm(settle_until_);
      return;
    }
    in_flight_ = *next;
    queue.erase(next);
    break;
  }
  if (!in_flight_) return;
  const Transaction& t = in_flight_->transaction;
  sent_at_ = now;
  latest_end_ = Instant::max();
  last_sender_ = &in_flight_->station;
  if (window_) {
    in_flight_->its_turn = true;
    in_flight_->suspended.resume(scheduler_.executor());
    return;
  }
  last_sender_->record(sent_at_, Way::sent, traffic_kind(t), t.bytes);
  if (!in_flight_->is_question()) {
    stream_->send(t.bytes);
    // It stays in flight while its bytes are on the wire: the next text, perhaps a stop, must not wait in the
    // port's own queue, where nothing overtakes.
    const Duration on_wire = wire_time(t.bytes.size());
    if (on_wire == Duration::zero()) return finish(std::string());
    deadline_.arm(sent_at_ + on_wire);
    return;
  }
  constexpr std::size_t usual_answer = 16;
  deadline_.arm(deadline_at_ =
                    sent_at_ + patience_for(*last_sender_, t) + wire_time(t.bytes.size() + usual_answer));
  if (!waiting_[static_cast<std::size_t>(Priority::stop)].empty()) shorten_for_stop();
  stream_->send(t.bytes);
}

Duration Link::patience_for(const Station& station, const Transaction& t) const {
  const bool is_stop = t.priority == Priority::stop && !t.own_question;  // repeated rather than waited for
  const Duration most = t.impatient ? Duration::zero() : is_stop ? longest_wait_of_a_stop : Duration::max();
  const Duration late = std::min(station.lateness(), most);
  return (t.prompt ? reply_times_.patience_of_prompt(t.patience, station_count()) : t.patience) + late;
}

bool Link::outstanding_by_others(const Station& asking, ReplyKind reply_kind) const {
  const Instant now = scheduler_.now();
  return left_outstanding_.may_be_outstanding(reply_kind, now) ||
         std::any_of(stations_.begin(), stations_.end(), [&](const Station* s) {
           return s != &asking && s->outstanding_.may_be_outstanding(reply_kind, now);
         });
}

void Link::finish(Result<std::string> result) {
  Pending* done = std::exchange(in_flight_, nullptr);
  deadline_.disarm();
  const Instant now = scheduler_.now();
  if (done->its_turn && result) done->station.received_at_ = now;
  if (done->is_question() && result) {
    done->station.answered_at_ = now;
    done->station.outstanding_.take(done->transaction.reply_kind, now);
  }
  if (done->its_turn)
    done->station.count_burst(result.has_value());
  else
    done->station.count(result, done->is_question(), done->transaction.priority == Priority::poll,
                        now - sent_at_, now);
  end(*done, std::move(result));
  start_next();
}

void Link::end(Pending& pending, Result<std::string> result) {
  pending.result = std::move(result);
  pending.finished = true;
  pending.suspended.resume(scheduler_.executor());
}

void Link::on_deadline() {
  if (!in_flight_) return;
  if (!in_flight_->is_question()) return finish(std::string());
  if (in_flight_->transaction.reply.kind == ReplyShape::Kind::quiet_end && !received_.empty()) {
    in_flight_->station.record(scheduler_.now(), Way::received, traffic_kind(in_flight_->transaction),
                               received_);
    finish(std::exchange(received_, {}));
    return;
  }
  if (in_flight_->transaction.may_be_silent && received_.empty())
    return finish(fail(FaultKind::no_answer, "The controller did not answer."));
  link_log().debug("{}no reply to \"{}\" in {:.0f} ms; received: \"{}\"",
                   OfDevice{in_flight_->station.address}, log::Bytes{in_flight_->transaction.bytes},
                   1e3 * seconds(scheduler_.now() - sent_at_), log::Bytes{received_});
  StationStatistics& statistics = in_flight_->station.statistics_;
  ++statistics.timeouts;
  ++statistics.misses_in_a_row;
  reply_times_.missed();
  in_flight_->station.outstanding_.add(in_flight_->transaction.reply_kind, scheduler_.now());
  if (!received_.empty()) in_flight_->station.outstanding_.tear(scheduler_.now());
  if (!in_flight_->station.unmistakable) settle_until_ = scheduler_.now() + settle_time;
  Fault fault(FaultKind::no_answer, "The controller did not answer in time.");
  if (!received_.empty()) {
    fault = Fault(FaultKind::garbled, "The controller's reply stopped in the middle.",
                  "The part received was not used.", "Check the cable.");
    give_up_on(std::exchange(received_, {}));
  }
  finish(fail(std::move(fault)));
}

void Link::drop_waiting(const Station& station, const Fault& why) {
  for (auto& queue : waiting_)
    std::erase_if(queue, [&](Pending* p) {
      if (&p->station != &station) return false;
      link_log().debug("{}\"{}\" dropped before it was sent: {}", OfDevice{station.address},
                       log::Bytes{p->transaction.bytes}, why.what);
      end(*p, fail(why));
      return true;
    });
}

// ---- what comes in

void Link::bytes_arrived(std::string_view bytes) {
  const auto keep = shared_from_this();
  if (Station* station = in_flight_ ? &in_flight_->station : last_sender_)
    station->received_at_ = scheduler_.now();
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, longest_unfinished);
    bytes.remove_prefix(part.size());
    received_.append(part);
    take_received();
    if (received_.size() > longest_unfinished) end_overlong_reply();
  }
}

/// No reply is that long: handled like one that never ended.
void Link::end_overlong_reply() {
  if (in_flight_ && in_flight_->is_question()) return on_deadline();
  give_up_on(std::exchange(received_, {}));
}

// False: the received bytes may still be a reply.
bool Link::take_unsolicited() {
  const auto& unsolicited_length = in_flight_->transaction.unsolicited_length;
  if (!unsolicited_length) return true;
  std::size_t length = 0, next = 0;
  while (length < received_.size() &&
         (next = unsolicited_length(std::string_view(received_).substr(length))) > 0) {
    if (next == std::string_view::npos) break;
    length += next;
  }
  if (length > 0) {
    const std::string taken = received_.substr(0, length);
    received_.erase(0, length);
    if (const std::size_t given = give_unsolicited(taken); given < taken.size())
      give_up_on(std::string_view(taken).substr(given));
  }
  return next != std::string_view::npos;
}

// Bytes may come with gaps: a reply that is coming in is waited for, unless a stop waits. A babbling device
// must not hold the wire for ever.
void Link::receive_to_end() {
  constexpr Duration longest_gap = Millis(60), longest_answer = std::chrono::seconds(1);
  const Transaction& t = in_flight_->transaction;
  const bool is_stop = t.priority == Priority::stop && !t.own_question;  // a stop is repeated
  if (is_stop || !waiting_[static_cast<std::size_t>(Priority::stop)].empty()) return;
  const Instant latest = std::min({scheduler_.now() + longest_gap, sent_at_ + longest_answer, latest_end_});
  if (latest > deadline_at_) deadline_.arm(deadline_at_ = latest);
}

void Link::take_received() {
  while (!received_.empty()) {
    if (!in_flight_ || in_flight_->transaction.reply.kind == ReplyShape::Kind::none) {
      const std::string unsolicited = std::exchange(received_, {});
      received_ = unsolicited.substr(give_unsolicited(unsolicited));
      if (!received_.empty()) unfinished_.arm(scheduler_.now() + settle_time);
      return;
    }
    if (!take_unsolicited()) return;
    if (!in_flight_ || received_.empty()) continue;
    const Transaction& t = in_flight_->transaction;
    if (t.reply.kind == ReplyShape::Kind::quiet_end) {
      deadline_.arm(deadline_at_ = scheduler_.now() + Millis(t.reply.quiet_ms) + wire_time(2));
      return;
    }
    const auto length = t.reply.complete(received_);
    if (!length) return receive_to_end();
    std::string reply = received_.substr(0, *length);
    received_.erase(0, *length);
    const Instant now = scheduler_.now();
    in_flight_->station.record(now, Way::received, traffic_kind(t), reply);
    reply_times_.answered(t.prompt, now - sent_at_ - wire_time(t.bytes.size() + reply.size()));
    finish(std::move(reply));
  }
}

// Offers unsolicited bytes to the stations; returns how many were used. 0: none, npos: a station needs more.
// A station that has just used some has used all that it could.
std::size_t Link::offer(std::string_view bytes, const Station*& took) {
  std::size_t answer = 0;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    Station& station = *stations_[i];
    if (&station == took || !station.unsolicited) continue;
    const std::size_t understood = station.unsolicited(bytes);
    if (understood == std::string_view::npos) answer = understood;
    if (understood == 0 || understood == std::string_view::npos) continue;
    answer = std::min(understood, bytes.size());
    station.record(scheduler_.now(), Way::received, TrafficKind::unsolicited, bytes.substr(0, answer));
    took = &station;
    break;
  }
  return answer;
}

// Returns how many bytes were used; the rest may be the beginning of a message.
std::size_t Link::give_unsolicited(std::string_view bytes) {
  std::size_t given = 0;
  const Station* took = nullptr;
  while (given < bytes.size()) {
    const std::size_t understood = offer(bytes.substr(given), took);
    if (understood == std::string_view::npos) return given;
    if (understood == 0) {
      give_up_on(bytes.substr(given));
      return bytes.size();
    }
    given += understood;
  }
  return given;
}

void Link::give_up_waiting() {
  if (in_flight_ && in_flight_->is_question()) return;  // handled at its deadline
  if (!received_.empty()) give_up_on(std::exchange(received_, {}));
}

// Counted at the station that sent last: most likely they answer that.
void Link::give_up_on(std::string_view bytes) {
  if (stations_.empty()) return;
  Station& station = last_sender_ ? *last_sender_ : *stations_.front();
  station.statistics_.unparsed_bytes += bytes.size();
  link_log().debug("{}bytes not understood: \"{}\"", OfDevice{station.address}, log::Bytes{bytes});
  station.record(scheduler_.now(), Way::received, TrafficKind::unparsed, bytes);
}

}  // namespace hw
