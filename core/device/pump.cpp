#include "core/device/pump.h"

#include <algorithm>

#include <fmt/core.h>

namespace hw {
namespace {

constexpr int forced_fast_polls = 3;  // a controller's status may lag behind the command by a round or two
constexpr std::size_t most_queued = 64;

bool starts_motion(const IntentBody& body) {
  return std::holds_alternative<intent::MoveTo>(body) || std::holds_alternative<intent::MoveBy>(body) ||
         std::holds_alternative<intent::JogStart>(body) || std::holds_alternative<intent::Home>(body) ||
         std::holds_alternative<intent::RunProgram>(body);
}

Duration back_off(int attempt) {
  constexpr Millis steps[] = {Millis(250), Millis(500), Millis(1000), Millis(2000), Millis(5000)};
  return steps[std::min<std::size_t>(attempt, std::size(steps) - 1)];
}

}  // namespace

struct Pump::Job {
  Intent intent;
  bool is_query = false;
  std::string text;
  Duration patience{};
  Result<std::string> reply{std::string()};
  Suspended asker;
  bool answered = false;
  explicit Job(Intent i) : intent(std::move(i)) {}
};

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
  driver_ = type.make_driver(DriverContext{scheduler, catalog_, draft_, ways_.notify, changed, ways_.sample});
}

Pump::~Pump() = default;

void Pump::start() {
  running_ = true;
  asio::co_spawn(scheduler_.executor(), live(), asio::detached);
}

Task<> Pump::shut_down() {
  if (!running_) co_return;
  closing_ = true;
  if (jogging_ && station_) {
    ++stops_under_way_;
    Intent farewell(0, intent::Stop());
    co_await stop_and_report(std::move(farewell));
  }
  refuse_queued("The controller was closed. Nothing was sent.");
  if (station_) station_->close(Fault(FaultKind::lost, "The controller was closed."));
  wake_.notify();
  while (running_ || stops_under_way_ > 0) co_await ended_.wait();
}

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
  station_->closed = [this](const Fault& why) {
    lose_wire(why);
    wake_.notify();
  };
  auto connected = co_await driver_->connect(*station_);
  if (closing_) co_return false;
  if (!connected) {
    lose_wire(connected.error());
    co_return false;
  }
  attempt_ = 0;
  draft_.link.state = LinkState::good;
  draft_.link.attempts = 0;
  draft_.link.misses_in_a_row = 0;
  draft_.link.sentence.clear();
  next_poll_ = scheduler_.now();
  fast_polls_ = forced_fast_polls;
  publish();
  co_return true;
}

/// A stop runs beside this life and may still be on its way on the wire that is gone: it ends first.
Task<> Pump::leave_wire() {
  while (stops_under_way_ > 0) co_await ended_.wait();
  station_.reset();
}

Task<> Pump::wait_for_retry() {
  refuse_queued("The controller does not answer. Nothing was sent.");
  draft_.link.next_attempt = scheduler_.now() + back_off(attempt_);
  publish();
  while (!closing_ && !retry_now_ && scheduler_.now() < draft_.link.next_attempt) {
    co_await wake_.wait_until(draft_.link.next_attempt);
    refuse_queued("The controller does not answer. Nothing was sent.");
  }
  retry_now_ = false;
}

void Pump::lose_wire(const Fault& why) {
  if (draft_.link.state != LinkState::lost) draft_.link.lost_at = scheduler_.now();
  draft_.link.state = LinkState::lost;
  draft_.link.sentence = why.sentence();
  dead_man_.disarm();
  jogging_ = false;
  if (station_) station_->close(why);
  driver_->wire_lost();
  publish();
}

Task<> Pump::serve() {
  while (!closing_ && station_->is_open()) {
    if (stops_under_way_ == 0 && !queue_.empty()) {
      station_->end_stop();
      co_await perform_next();
      fast_polls_ = forced_fast_polls;
      next_poll_ = scheduler_.now();
      continue;
    }
    if (scheduler_.now() < next_poll_) {
      co_await wake_.wait_until(next_poll_);
      continue;
    }
    ++rounds_begun_;
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

Task<> Pump::refresh() {
  const std::uint64_t wanted = rounds_begun_ + 1;
  const auto connected = [this] {
    return draft_.link.state == LinkState::good || draft_.link.state == LinkState::late;
  };
  if (!connected()) co_return;
  round_wanted_ = std::max(round_wanted_, wanted);
  next_poll_ = scheduler_.now();
  wake_.notify();
  while (rounds_ended_ < wanted && connected() && !closing_) co_await published_.wait();
}

// ---- intents

void Pump::post(Intent intent) {
  if (std::holds_alternative<intent::JogKeepAlive>(intent.body)) {
    if (jogging_ && dead_man_.armed()) dead_man_.arm(scheduler_.now() + dead_man);
    return;
  }
  if (std::holds_alternative<intent::JogStop>(intent.body) && !jogging_) {
    // Released twice, or a jog that was refused. A second stop would mean: at once, without a ramp.
    set_fate(intent.id, Fate::done);
    return publish();
  }
  const bool stop = std::holds_alternative<intent::Stop>(intent.body) ||
                    std::holds_alternative<intent::Abort>(intent.body) ||
                    std::holds_alternative<intent::JogStop>(intent.body) ||
                    std::holds_alternative<intent::HaltProgram>(intent.body);
  if (stop) return post_stop(std::move(intent));
  if (std::holds_alternative<intent::Reconnect>(intent.body)) {
    retry_now_ = true;
    set_fate(intent.id, Fate::done);
    wake_.notify();
    return;
  }
  set_fate(intent.id, Fate::pending);
  if (queue_.size() >= most_queued) {
    set_fate(intent.id, Fate::refused, "Too many commands wait already. This one was not sent.");
    return publish();
  }
  hold_jog(intent);
  queue_.push_back(std::make_unique<Job>(std::move(intent)));
  wake_.notify();
}

void Pump::hold_jog(const Intent& intent) {
  const auto* jog = std::get_if<intent::JogStart>(&intent.body);
  if (!jog) return;
  jogging_ = true;
  if (jog->dead_man) dead_man_.arm(scheduler_.now() + dead_man);
}

void Pump::jog_let_go() {
  ways_.notify(Notice(Notice::Kind::warning, scheduler_.now(),
                      "The console did not hold the jog any more, so the axis was stopped."));
  post_stop(Intent(0, intent::JogStop()));
}

void Pump::refuse_queued(const char* why) {
  for (auto& job : queue_) {
    set_fate(job->intent.id, Fate::refused, why);
    if (job->is_query) {
      job->reply = fail(FaultKind::refused, why);
      job->answered = true;
      job->asker.resume(scheduler_.executor());
      job.release();  // its asker owns it from here
    }
  }
  if (!queue_.empty()) {
    queue_.clear();
    publish();
  }
}

void Pump::post_stop(Intent intent) {
  // Halting one of several threads leaves the motion alone: a held jog stays guarded.
  const bool motion_goes_on =
      std::holds_alternative<intent::HaltProgram>(intent.body) && catalog_.program.threads > 0;
  if (!motion_goes_on) {
    dead_man_.disarm();
    jogging_ = false;
  }
  refuse_queued("A stop came first. This was not sent.");
  set_fate(intent.id, Fate::pending);
  if (!station_ || !station_->is_open()) {
    set_fate(intent.id, Fate::failed,
             "Stop does not reach the controller: there is no connection. Use its power switch.");
    return publish();
  }
  station_->begin_stop();
  ++stops_under_way_;
  asio::co_spawn(scheduler_.executor(), stop_and_report(std::move(intent)), asio::detached);
}

bool Pump::stop_wire(bool at_once) {
  if (!station_ || !station_->is_open()) return false;
  ++stops_under_way_;
  asio::co_spawn(scheduler_.executor(), run_stop_wire(at_once), asio::detached);
  return true;
}

Task<> Pump::run_stop_wire(bool at_once) {
  try {
    auto stopped = co_await driver_->stop_wire(at_once);
    if (!stopped) ways_.notify(Notice(Notice::Kind::error, scheduler_.now(), stopped.error().sentence()));
  } catch (const std::exception& defect) {
    ways_.notify(Notice(Notice::Kind::error, scheduler_.now(),
                        fmt::format("The stop of all failed inside: {}.", defect.what())));
  }
  --stops_under_way_;
  wake_.notify();
  ended_.notify();
}

Task<Result<>> Pump::stop_as_asked(const IntentBody& body) {
  if (const auto* s = std::get_if<intent::Stop>(&body)) return driver_->stop(s->axis, false);
  if (const auto* a = std::get_if<intent::Abort>(&body)) return driver_->stop(a->axis, true);
  if (const auto* h = std::get_if<intent::HaltProgram>(&body)) return driver_->halt_program(h->thread);
  return driver_->stop_jog();
}

Task<> Pump::stop_and_report(Intent intent) {
  try {
    auto stopped = co_await stop_as_asked(intent.body);
    if (stopped)
      set_fate(intent.id, Fate::done);
    else
      set_fate(intent.id, Fate::failed, stopped.error().sentence());
  } catch (const std::exception& defect) {
    set_fate(intent.id, Fate::failed, fmt::format("The stop failed inside: {}.", defect.what()));
  }
  --stops_under_way_;
  next_poll_ = scheduler_.now();
  fast_polls_ = forced_fast_polls;
  publish();
  wake_.notify();
  ended_.notify();
}

Task<> Pump::perform_next() {
  std::unique_ptr<Job> job = std::move(queue_.front());
  queue_.pop_front();
  performing_ = true;
  if (job->is_query) {
    job->reply = co_await driver_->query(job->text, job->patience);
    job->answered = true;
    performing_ = false;
    job->asker.resume(scheduler_.executor());
    job.release();  // its asker owns it from here
    co_return;
  }
  auto performed = co_await driver_->perform(job->intent.body);
  performing_ = false;
  if (performed)
    set_fate(job->intent.id, Fate::done);
  else
    set_fate(job->intent.id, performed.error().kind == FaultKind::refused ? Fate::refused : Fate::failed,
             performed.error().sentence());
  if (!performed && starts_motion(job->intent.body)) {
    jogging_ = false;
    dead_man_.disarm();
  }
  publish();
}

Task<Result<std::string>> Pump::query(std::string text, Duration patience) {
  if (draft_.link.state == LinkState::lost || draft_.link.state == LinkState::closed)
    co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
  auto owned = std::make_unique<Job>(Intent(0, intent::SendText(text)));
  Job* job = owned.get();
  job->is_query = true;
  job->text = std::move(text);
  job->patience = patience;
  queue_.push_back(std::move(owned));
  wake_.notify();
  while (!job->answered) co_await job->asker.here();
  std::unique_ptr<Job> mine(job);
  co_return std::move(mine->reply);
}

// ---- what is told

void Pump::set_fate(IntentId id, Fate fate, std::string_view sentence) {
  if (id == 0) return;
  auto& fates = draft_.fates;
  auto at = std::find_if(fates.begin(), fates.end(), [&](const IntentFate& f) { return f.id == id; });
  if (at == fates.end()) {
    std::move_backward(fates.begin(), fates.end() - 1, fates.end());
    at = fates.begin();
    at->id = id;
  }
  at->fate = fate;
  at->sentence = sentence;
}

void Pump::publish() {
  ++draft_.sequence;
  draft_.at = scheduler_.now();
  ways_.publish(draft_);
  published_.notify();
}

}  // namespace hw
