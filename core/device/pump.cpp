// Connecting, polling, and the loss of the connection. Reports: pump_reports.cpp. Commands: pump_intents.cpp.
#include <algorithm>

#include <fmt/core.h>

#include "core/device/pump_job.h"
#include "core/device/refusals.h"

namespace hw {
namespace {

constexpr Duration longest_clearing = std::chrono::seconds(8);  // the longest ramp, with a margin
constexpr int times_blind = 3;  // sends of a stop to a controller that has never answered
constexpr Duration others_take =
    std::chrono::seconds(1);  // for the other controllers to end their present round
constexpr Duration longest_end_of_a_command = std::chrono::seconds(1), longest_last_look = Millis(500);

}  // namespace

Pump::Pump(Scheduler& scheduler, const DeviceType& type, const Catalog& catalog, Callbacks callbacks)
    : scheduler_(scheduler),
      catalog_(catalog),
      callbacks_(std::move(callbacks)),
      tool_(catalog),
      jogs_(scheduler, [this] { jog_let_go(); }),
      pieces_(catalog, snapshot_, wake_),
      endings_(catalog, callbacks_.ended, [this](int slot) { return loaded_.ways_of(slot); }),
      counts_(catalog),
      loaded_(catalog, type.language ? &type.language() : nullptr),
      wake_(scheduler),
      published_(scheduler),
      ended_(scheduler),
      silence_(scheduler, [this] {
        if (!station_) return;
        const bool silent = station_->received_at() < outage_.attempt_at();
        if (!silent && !outage_.takes_too_long(scheduler_.now())) return silence_.arm(outage_.latest());
        pump_log().debug("{}: no reply while a stop is pending; connecting starts again", LogName{catalog_});
        station_->preempt();
      }) {
  snapshot_.axis_count = static_cast<int>(catalog.axes.size());
  snapshot_.slot_bytes_used.fill(-1);
  snapshot_.identity.model = catalog.name;
  const auto changed = [this] {
    rounds_.due_at(scheduler_.now());
    publish();
    wake_.notify();
  };
  driver_ = type.make_driver(
      DriverContext{scheduler, catalog_, snapshot_, texts_, callbacks_.notify, changed, callbacks_.sample});
  will_ = std::make_unique<JogWill>(*driver_);
  if (callbacks_.line) callbacks_.line->join(*this, catalog_.address);
}

Pump::~Pump() {
  if (callbacks_.line) callbacks_.line->leave(*this);
}

void Pump::start() {
  lifecycle_ = Lifecycle::runs;
  asio::co_spawn(scheduler_.executor(), live(), asio::detached);
}

Task<> Pump::shut_down() {
  if (!runs()) co_return;
  lifecycle_ = Lifecycle::leaves;
  pump_log().debug("{}: is closed", LogName{catalog_});
  refuse_queued(was_closed);
  if (jogs_.any()) post_stop(StopOrder());
  co_await let_end();
  for (std::string left : {driver_->leaves_behind(), describe_torn_is_left(catalog_, snapshot_)})
    if (!left.empty())  // what the controller keeps stays there while the link is lost
      callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(), std::move(left)));
  lifecycle_ = Lifecycle::closes;
  if (callbacks_.line) callbacks_.line->leave(*this);
  if (station_) station_->close(Fault(FaultKind::lost, "The controller was closed."));
  wake_.notify();
  published_.notify();
  while (runs()) co_await ended_.wait();
  published_.notify();
  stops_did_not_arrive();
  desk_.clear();
  refuse_queued(was_closed);
  while (asking_ > 0) co_await ended_.wait();
}

// Lets commands under way end, if that is near. A stop requested a moment ago may still wait for the answer
// to a question, or for a lost wire. A stop that is requested while closing can still be sent until the last
// status round has shown what runs.
Task<> Pump::let_end() {
  const Instant began = scheduler_.now(), given_up = began + longest_clearing;
  const Instant cut_off = began + longest_end_of_a_command;
  while (connected() && jobs_.performs() && scheduler_.now() < cut_off)
    co_await published_.wait_until(cut_off);
  const bool may_run = something_runs() || rounds_.often();
  const std::uint64_t last_look = may_run && !jobs_.performs() ? want_round() : 0;
  const Instant looked_by = scheduler_.now() + longest_last_look;  // the next opener waits for the port
  for (;;) {
    const Instant now = scheduler_.now();
    const bool has_wire = station_ && station_->is_open();
    const bool never_seen = rounds_.ended() == 0 && !connected();
    const bool owes = never_seen ? has_wire && !desk_.all_were_sent(times_blind) : desk_.any();
    const bool looks = connected() && last_look > 0 && !has_seen(last_look) && now < looked_by;
    const bool clears = connected() && driver_->clears_up();
    if (!(owes || looks || clears) || now >= given_up) co_return;
    co_await published_.wait_until(looks ? looked_by : given_up);
  }
}

bool Pump::connected() const { return snapshot_.link.connected(); }

bool Pump::something_runs() const {
  const RunState run = snapshot_.program.run;
  return snapshot_.any_axis_moving() || run == RunState::running || run == RunState::waiting;
}

// ---- the life of the connection

Task<> Pump::live() {
  publish();
  while (!closes()) {
    bool made = false;
    try {
      made = co_await open_and_connect();
      if (made) co_await serve();
    } catch (const std::exception& defect) {  // from a library; nothing above may see it
      lose_wire(Fault(FaultKind::internal,
                      fmt::format("An internal error ended the connection: {}.", defect.what())));
    }
    if (!closes()) co_await wait_for_retry();
  }
  snapshot_.link.state = LinkState::closed;
  station_.reset();
  publish();
  lifecycle_ = Lifecycle::over;
  ended_.notify();
}

Task<bool> Pump::open_and_connect() {
  snapshot_.link.state = LinkState::connecting;
  snapshot_.link.attempts = outage_.try_again(scheduler_.now());
  publish();
  const Station::ReplyState reply_state = station_ ? station_->reply_state() : Station::ReplyState();
  station_.reset();
  auto opened = co_await callbacks_.open_wire();
  if (closes()) co_return false;
  if (!opened) {
    lose_wire(opened.error());
    co_return false;
  }
  station_ = std::make_unique<Station>(std::move(*opened), callbacks_.traffic);
  station_->address = catalog_.address;
  station_->take_over(reply_state);
  station_->recorded = callbacks_.recorded;
  station_->stops = [this] { return desk_.uses_the_wire(); };
  station_->closed = [this](const Fault& why) {
    lose_wire(why);
    wake_.notify();
  };
  driver_->attach(*station_);
  co_return co_await connect();
}

/// True after a lost wire, or if the controller has answered and its state is not known yet.
bool Pump::something_may_run() const { return outage_.may_run() || (station_ && station_->has_received()); }

/// A few times if no controller has ever answered: there may be none.
bool Pump::stop_goes_out_again() const {
  return desk_.any() && (something_may_run() || !desk_.all_were_sent(times_blind));
}

// Pending stops are sent before anything else that connecting needs, and again as long as nothing is
// received.
Task<bool> Pump::connect() {
  for (;;) {
    outage_.tried_at(scheduler_.now());
    station_->begin_procedure();
    if (StopOrder* stop = desk_.due()) {
      co_await send_stop(*stop);
      if (closes() || !station_->is_open()) co_return false;
      continue;
    }
    if (stop_goes_out_again())
      silence_.arm(something_may_run() ? outage_.attempt_at() + retry_with_a_stop : outage_.latest());
    auto made = co_await guarded("connection", driver_->connect());
    silence_.disarm();
    if (closes() || !station_->is_open()) co_return false;
    if (station_->preempted()) {  // by a stop, or because nothing is received
      const bool was_silent = scheduler_.now() - outage_.attempt_at() >= retry_with_a_stop;
      if (!desk_.due() && was_silent) nothing_comes_back();
      continue;
    }
    if (made) break;
    lose_wire(made.error());
    co_return false;
  }
  connection_made();
  co_return true;
}

/// No reply to a stop, nor to any question after it. If no controller has answered yet, the end of the
/// attempt reports the reason.
void Pump::nothing_comes_back() {
  desk_.send_all_again();
  if (!something_may_run()) return;
  snapshot_.link.state = LinkState::lost;
  if (rounds_.ended() > 0)  // else the sentence already says why there is no answer yet
    snapshot_.link.sentence =
        "Stop was sent, but the controller does not answer. The stop is sent again until it does.";
  stops_did_not_arrive();
  refuse_queued(does_not_answer);
  publish();
}

void Pump::connection_made() {
  if (outage_.end(snapshot_))  // a run seen now was started by another host
    desk_.orders().remove_if(
        [](const StopOrder& order) { return order.reported && order.what != StopOrder::What::tool; });
  pump_log().debug("{}: connected at attempt {}", LogName{catalog_}, snapshot_.link.attempts);
  snapshot_.link.state = LinkState::good;
  snapshot_.link.when_lost = UnderWay();
  snapshot_.link.attempts = 0;
  snapshot_.link.misses_in_a_row = 0;
  snapshot_.link.sentence.clear();
  rounds_.look_often(scheduler_.now());
  for (StopOrder& order : desk_.orders())  // a typed text may have been sent on a dead wire
    if (order.what == StopOrder::What::words) order.what = StopOrder::What::everything;
  const auto& stops = desk_.orders();
  if (something_runs() &&
      std::any_of(stops.begin(), stops.end(), [](const auto& order) { return order.reported; }))
    callbacks_.notify(Notice(
        Notice::Kind::warning, scheduler_.now(),
        "The axis is being stopped now: it still moved after the link was lost during a jog or a stop."));
  publish();
}

Task<> Pump::wait_for_retry() {
  refuse_queued(outage_.hurries() ? snapshot_.link.sentence.view() : does_not_answer);
  const auto next = [this] {
    return desk_.any() ? outage_.attempt_at() + retry_with_a_stop : scheduler_.now() + outage_.back_off();
  };
  snapshot_.link.next_attempt = next();
  if (!outage_.hurries())
    pump_log().debug("{}: the next attempt to connect is in {:.1f} s", LogName{catalog_},
                     seconds(snapshot_.link.next_attempt - scheduler_.now()));
  publish();
  while (!closes() && !outage_.hurries() && scheduler_.now() < snapshot_.link.next_attempt) {
    co_await wake_.wait_until(snapshot_.link.next_attempt);
    refuse_queued(does_not_answer);
  }
}

void Pump::lose_wire(const Fault& why) {
  Outage::Loss loss;
  loss.at_work = something_runs() || jogs_.any();
  loss.on_the_way = jobs_.performs();
  const bool not_seen_yet = rounds_.often();  // a command sent a moment ago may have started a motion
  // The state of a controller that has never answered is unknown, so a stop stays pending.
  const bool never_seen = rounds_.ended() == 0;
  loss.may_run =
      never_seen || not_seen_yet || loss.at_work || loss.on_the_way || (connected() && desk_.any());
  if (outage_.begin(snapshot_, loss, scheduler_.now())) {
    snapshot_.link.lost_at = scheduler_.now();
    snapshot_.link.when_lost = snapshot_.shows_under_way();
  }
  snapshot_.link.state = LinkState::lost;
  snapshot_.link.sentence = why.sentence();
  pump_log().debug("{}: lost: {}", LogName{catalog_}, snapshot_.link.sentence.view());
  if (will_->may_be_carried_out())  // the wire may be back before the user has read why it was given up
    callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(), why.sentence()));
  const bool together = pieces_.runs_together();
  pieces_.end();
  keep_stops_at_loss(why, together);
  jogs_.stop(-1);
  loaded_.forget();  // meanwhile it may be switched off, or loaded with other programs
  if (station_) station_->give_up(why);
  driver_->wire_lost();
  publish();
}

Task<> Pump::serve() {
  while (!closes() && station_->is_open()) {
    station_->begin_procedure();
    if (StopOrder* stop = desk_.due()) {
      const bool words = stop->what == StopOrder::What::words;  // the text may do more than stop
      if (words) disturbed();
      co_await send_stop(*stop);
      if (words) endings_.disturbed();
      rounds_.due_at(scheduler_.now() + driver_->moving_period());
    } else if (!desk_.any() && !jobs_.empty() && !tool_is_seen_first()) {
      const bool disturbs = !only_looks(jobs_.next()), program = only_handles_programs(jobs_.next());
      if (disturbs) counts_.disturbed();
      if (disturbs && !program) endings_.disturbed();
      co_await perform_next();
      if (disturbs && !program) endings_.disturbed();  // it may have been read before the command acted
      rounds_.look_often(scheduler_.now());
    } else if (const IntentBody* piece = pieces_.due(rounds_.ended(), scheduler_.now());
               piece && !desk_.any() && !leaves()) {
      disturbed();
      co_await perform_piece(*piece);
      rounds_.look_often(scheduler_.now());
    } else if (pieces_.waits_for_others() && !desk_.any() && jobs_.empty() && !leaves() &&
               scheduler_.now() < rounds_.next() + others_take) {
      co_await wake_.wait_until(rounds_.next() + others_take);
    } else if (scheduler_.now() < rounds_.next()) {
      co_await wake_.wait_until(rounds_.next());
    } else {
      co_await run_round();
    }
  }
}

// Only the stop uses the wire of its controller until everything stands. A caller that waits for a round gets
// one in between once the stop has been confirmed.
Round Pump::next_round() const {
  const auto& stops = desk_.orders();
  const bool confirmed = std::all_of(stops.begin(), stops.end(), [](const auto& o) { return o.confirmed; });
  const bool prompt = stops.empty() || !station_->is_dirty();  // else the questions take seconds
  if (rounds_.one_is_wanted() && confirmed && prompt) return Round::everything;
  return stops.empty() ? Round::usual : desk_.only_tool() ? Round::everything : Round::stopping;
}

Task<> Pump::run_round() {
  const Round round = next_round();
  if (round != Round::stopping) rounds_.begin();
  auto polled = co_await driver_->poll(round);
  if (!station_->is_open()) co_return;  // lose_wire() has reported everything
  if (station_->preempted()) {          // cut short by a stop: it does not count as a round
    pump_log().debug("{}: a stop has interrupted a status round", LogName{catalog_});
    if (round != Round::stopping) rounds_.cut();
    co_return;
  }
  if (round != Round::stopping) rounds_.end();
  poll_finished(polled);
  if (!polled || !station_->is_open()) co_return;
  if (round != Round::stopping) watch_counts();
  watch_tool();
  // Without a stop this controller would drive on alone to the end of its line. A pending stop of all axes
  // suffices.
  if (pieces_.others_have_ended() && snapshot_.any_axis_moving() && !desk_.stops_all()) {
    pump_log().debug("{}: stopped, because another controller of the drawing has ended", LogName{catalog_});
    StopOrder order;
    order.by = StoppedBy::unknown;  // on this controller
    post_stop(std::move(order));
  }
  const bool cuts = snapshot_.pieces.draws;
  if (std::string why = pieces_.watch(rounds_.ended()); !why.empty()) pieces_end(std::move(why), cuts);
}

bool Pump::is_silent() const {
  return station_->is_open() && station_->statistics().misses_in_a_row >= misses_until_lost;
}

Fault Pump::not_answering() const {
  return Fault(FaultKind::lost,
               fmt::format("The controller did not answer {} times.", station_->statistics().misses_in_a_row),
               "No command was repeated and no motion will resume by itself.",
               "Check its power, the cable and the baud rate.");
}

void Pump::poll_finished(const Result<>& result) {
  const StationStatistics& s = station_->statistics();
  LinkHealth& health = snapshot_.link;
  health.round_trip = s.last_round_trip;
  health.polls_per_second = static_cast<float>(s.polls_per_second);
  health.timeouts = s.timeouts;
  health.unparsed_bytes = s.unparsed_bytes;
  health.misses_in_a_row = static_cast<std::uint32_t>(s.misses_in_a_row);
  if (!result && result.error().kind == FaultKind::lost) return lose_wire(result.error());
  if (is_silent()) return lose_wire(not_answering());
  if (s.misses_in_a_row >= misses_until_a_jog_ends) stop_unseen_jogs();
  forget_jogs_that_ended();
  if (result)
    look_at_stops();
  else
    desk_.send_all_again();  // no reply shows that they have arrived
  if (!result)
    driver_log(catalog_).debug("{}: round failed: {}", LogName{catalog_}, result.error().sentence());
  if (result) report_loss();
  const bool understood =
      result || (result.error().kind != FaultKind::garbled && result.error().kind != FaultKind::refused);
  health.state = s.misses_in_a_row > 0 || !understood ? LinkState::late : LinkState::good;
  if (!result)
    health.sentence = result.error().sentence();
  else
    health.sentence.clear();
  const bool fast = desk_.any() || rounds_.often() || snapshot_.any_axis_moving() ||
                    snapshot_.program.run == RunState::running;
  snapshot_.poll_period = fast ? driver_->moving_period() : driver_->idle_period();
  rounds_.schedule(scheduler_.now(), snapshot_.poll_period);
  publish();
}

}  // namespace hw
