// Connecting, polling, what is lost and what is told. What is asked of it: pump_intents.cpp.
#include <algorithm>

#include <fmt/core.h>

#include "core/device/pump_job.h"

namespace hw {
namespace {

constexpr Duration longest_clearing = std::chrono::seconds(8);  // the longest ramp, and a little

Duration back_off(int attempt) {
  constexpr Millis steps[] = {Millis(250), Millis(500), Millis(1000), Millis(2000), Millis(5000)};
  return steps[std::min<std::size_t>(attempt, std::size(steps) - 1)];
}

}  // namespace

Pump::Pump(Scheduler& scheduler, const DeviceType& type, const Catalog& catalog, Ways ways)
    : scheduler_(scheduler),
      catalog_(catalog),
      ways_(std::move(ways)),
      wake_(scheduler),
      published_(scheduler),
      ended_(scheduler),
      dead_man_(scheduler, [this] { jog_let_go(); }) {
  draft_.axis_count = static_cast<int>(catalog.axes.size());
  draft_.slot_bytes_used.fill(-1);
  draft_.identity.model = catalog.name;
  const auto changed = [this] {
    next_poll_ = scheduler_.now();
    publish();
    wake_.notify();
  };
  const auto stop_heard = [this](bool all) {
    drop_what_waits();
    if (all) unanswered_stop_ = rounds_begun_;  // who says it learns nothing of whether it came here
    wake_.notify();
  };
  driver_ = type.make_driver(
      DriverContext{scheduler, catalog_, draft_, ways_.notify, changed, stop_heard, ways_.sample});
}

Pump::~Pump() = default;

void Pump::start() {
  running_ = true;
  asio::co_spawn(scheduler_.executor(), live(), asio::detached);
}

Task<> Pump::shut_down() {
  if (!running_) co_return;
  leaving_ = true;
  refuse_queued("The controller was closed. Nothing was sent.");
  if (jogs_.any()) post_stop(Intent(0, intent::Stop()));
  // A stop that was asked for a moment ago may still wait for the answer to a question.
  const Instant give_up = scheduler_.now() + longest_clearing;
  while (stops_under_way_ > 0 && scheduler_.now() < give_up) co_await ended_.wait_until(give_up);
  while (connected() && driver_->clears_up() && scheduler_.now() < give_up)
    co_await published_.wait_until(give_up);
  if (std::string left = driver_->leaves_behind(); connected() && !left.empty())
    ways_.notify(Notice(Notice::Kind::warning, scheduler_.now(), std::move(left)));
  closing_ = true;
  if (station_) station_->close(Fault(FaultKind::lost, "The controller was closed."));
  if (performing_ || answers_awaited_ > 0) driver_->wire_lost();  // nobody waits for an answer any more
  wake_.notify();
  while (running_ || stops_under_way_ > 0 || answers_awaited_ > 0) co_await ended_.wait();
  refuse_queued("The controller was closed. Nothing was sent.");
}

bool Pump::connected() const { return draft_.link.connected(); }

// ---- the life of the connection

Task<> Pump::live() {
  publish();
  while (!closing_) {
    bool connected = false;
    try {
      connected = co_await open_and_connect();
      if (connected) co_await serve();
    } catch (const std::exception& defect) {  // from a library; nothing above may see it
      lose_wire(Fault(FaultKind::internal, fmt::format("The connection failed inside: {}.", defect.what())));
    }
    if (!closing_) co_await wait_for_retry();
  }
  draft_.link.state = LinkState::closed;
  co_await leave_wire();
  publish();
  running_ = false;
  ended_.notify();
}

Task<bool> Pump::open_and_connect() {
  draft_.link.state = LinkState::connecting;
  draft_.link.attempts = ++attempt_;
  publish();
  co_await leave_wire();
  auto opened = co_await ways_.open_wire();
  if (closing_) co_return false;
  if (!opened) {
    lose_wire(opened.error());
    co_return false;
  }
  station_ = std::make_unique<Station>(std::move(*opened), ways_.traffic);
  station_->recorded = ways_.recorded;
  station_->closed = [this](const Fault& why) {
    lose_wire(why);
    wake_.notify();
  };
  const std::uint64_t stops_before = stops_begun_;
  auto connected = co_await driver_->connect(*station_);
  if (!connected && stops_begun_ != stops_before) {
    // Cut short by a stop, which goes out whole before this wire is left; then it is made again.
    while (stops_under_way_ > 0 && station_->is_open()) co_await ended_.wait();
    if (station_->is_open())
      connected = fail(FaultKind::lost, "A stop came while the connection was made, and went out first.", {},
                       "The connection is made again.");
    retry_now_ = true;
  }
  if (closing_) co_return false;
  if (!connected) {
    lose_wire(connected.error());
    co_return false;
  }
  attempt_ = 0;
  down_ = recovering_ = false;
  answer_recovery();
  draft_.link.state = LinkState::good;
  draft_.link.when_lost = UnderWay();
  draft_.link.attempts = 0;
  draft_.link.misses_in_a_row = 0;
  draft_.link.sentence.clear();
  next_poll_ = scheduler_.now();
  fast_polls_ = fast_polls_after_a_command;
  publish();
  make_good_the_stop();
  co_return true;
}

/// A stop runs beside this life and may still be on its way on the wire that is gone: it ends first.
Task<> Pump::leave_wire() {
  while (stops_under_way_ > 0) co_await ended_.wait();
  station_.reset();
}

Task<> Pump::wait_for_retry() {
  constexpr std::string_view silent = "The controller does not answer. Nothing was sent.";
  const bool says_why = std::exchange(recovering_, false) || retry_now_;  // a stop came, or a new attempt
  refuse_queued(says_why ? draft_.link.sentence.view() : silent);
  draft_.link.next_attempt = scheduler_.now() + back_off(attempt_);
  publish();
  while (!closing_ && !retry_now_ && scheduler_.now() < draft_.link.next_attempt) {
    co_await wake_.wait_until(draft_.link.next_attempt);
    if (!recovering_) refuse_queued(silent);
  }
  retry_now_ = false;
}

void Pump::lose_wire(const Fault& why) {
  if (!std::exchange(down_, true)) {  // attempts in between do not count
    draft_.link.lost_at = scheduler_.now();
    ran_when_lost_ = something_runs() || jogs_.any() || performing_;
    loss_.lost(draft_, something_runs() || jogs_.any(), performing_, scheduler_.now());
    draft_.link.when_lost = draft_.shows_under_way();
    restarts_when_lost_ = draft_.restarts;
  }
  if (std::exchange(unanswered_stop_, std::nullopt)) owed_stop_.add(-1);
  jogs_.for_each_axis([this](int axis) {
    owed_stop_.add(axis);
    if (axis >= 0) draft_.link.when_lost.axes |= 1u << axis;  // its motion may not have been seen yet
  });
  draft_.link.state = LinkState::lost;
  draft_.link.sentence = why.sentence();
  dead_man_.disarm();
  jogs_.stop(-1);
  if (station_) station_->give_up(why);
  driver_->wire_lost();
  publish();
}

Task<> Pump::serve() {
  while (!closing_ && station_->is_open()) {
    // What the stop has cut short has ended. A round of status may have to set up a restarted controller.
    if (stops_under_way_ == 0) station_->end_stop();
    if (stops_under_way_ == 0 && !queue_.empty()) {
      co_await perform_next();
      fast_polls_ = fast_polls_after_a_command;
      next_poll_ = scheduler_.now();
      continue;
    }
    if (scheduler_.now() < next_poll_) {
      co_await wake_.wait_until(next_poll_);
      continue;
    }
    driver_->everything_wanted = ++rounds_begun_ <= round_wanted_;
    auto polled = co_await driver_->poll();
    poll_finished(polled);
  }
}

void Pump::poll_finished(const Result<>& result) {
  rounds_ended_ = rounds_begun_;
  const StationStatistics& s = station_->statistics();
  LinkHealth& health = draft_.link;
  health.round_trip = s.last_round_trip;
  health.polls_per_second = static_cast<float>(s.polls_per_second);
  health.timeouts = s.timeouts;
  health.unparsed_bytes = s.unparsed_bytes;
  health.misses_in_a_row = static_cast<std::uint32_t>(s.misses_in_a_row);
  if (!station_->is_open()) return;  // lose_wire() has said it all
  if (!result && result.error().kind == FaultKind::lost) return lose_wire(result.error());
  if (s.misses_in_a_row >= misses_until_lost) {
    lose_wire(Fault(FaultKind::lost,
                    fmt::format("The controller has not answered {} times.", s.misses_in_a_row),
                    "No command was repeated and no motion will resume by itself.",
                    "Look at its power, the cable and the baud rate."));
    return;
  }
  forget_jogs_that_ended();
  if (result && !something_runs()) owed_stop_.forget();
  if (result) tell_what_came_of_the_loss();
  if (result && unanswered_stop_ && rounds_begun_ > *unanswered_stop_) unanswered_stop_.reset();
  const bool understood =
      result || (result.error().kind != FaultKind::garbled && result.error().kind != FaultKind::refused);
  health.state = s.misses_in_a_row > 0 || !understood ? LinkState::late : LinkState::good;
  if (!result)
    health.sentence = result.error().sentence();
  else
    health.sentence.clear();
  const bool fast = fast_polls_ > 0 || draft_.any_axis_moving() || draft_.program.run == RunState::running;
  if (fast_polls_ > 0) --fast_polls_;
  draft_.poll_period = fast ? driver_->moving_period() : driver_->idle_period();
  next_poll_ = scheduler_.now();
  if (rounds_ended_ >= round_wanted_) next_poll_ += draft_.poll_period;
  publish();
}

void Pump::tell_what_came_of_the_loss() {
  std::string told = loss_.back(catalog_, draft_, something_runs(), scheduler_.now());
  if (!told.empty()) ways_.notify(Notice(Notice::Kind::warning, scheduler_.now(), std::move(told)));
}

std::uint64_t Pump::want_round() {
  const std::uint64_t wanted = rounds_begun_ + 1;
  round_wanted_ = std::max(round_wanted_, wanted);
  next_poll_ = scheduler_.now();
  wake_.notify();
  return wanted;
}

Task<> Pump::refresh() {
  if (!connected()) co_return;
  const std::uint64_t wanted = want_round();
  while (rounds_ended_ < wanted && connected() && !closing_) co_await published_.wait();
}

void Pump::know_store_count(std::int32_t writes_used) {
  if (std::exchange(draft_.store_count, writes_used) != writes_used && running_) publish();
}

// ---- what is told

void Pump::set_fate(IntentId id, Fate fate, std::string_view sentence) {
  IntentFate told;
  told.id = id;
  told.fate = fate;
  told.sentence = sentence;
  set_fate(told);
}

void Pump::set_fate(const IntentFate& told) {
  if (told.id == 0) return;
  auto& fates = draft_.fates;
  auto at = std::find_if(fates.begin(), fates.end(), [&](const IntentFate& f) { return f.id == told.id; });
  if (at == fates.end()) {
    std::move_backward(fates.begin(), fates.end() - 1, fates.end());
    at = fates.begin();
  }
  *at = told;
}

void Pump::publish() {
  ++draft_.sequence;
  draft_.at = scheduler_.now();
  ways_.publish(draft_);
  published_.notify();
}

}  // namespace hw
