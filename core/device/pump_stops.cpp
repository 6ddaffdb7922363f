// Stops of an open controller, in the console's verbs or the controller's own words. They wait for nothing
// that is queued, and one that a lost wire may have swallowed is made good.
#include <fmt/core.h>

#include "core/device/pump_job.h"

namespace hw {

bool Pump::something_runs() const {
  const RunState run = draft_.program.run;
  return draft_.any_axis_moving() || run == RunState::running || run == RunState::waiting;
}

void Pump::owe_stop(const IntentBody& stop) {
  if (const auto* s = std::get_if<intent::Stop>(&stop))
    owed_stop_.add(s->axis);
  else if (const auto* a = std::get_if<intent::Abort>(&stop))
    owed_stop_.add(a->axis);
  else if (const auto* j = std::get_if<intent::JogStop>(&stop))
    owed_stop_.add(j->axis);
  else if (catalog_.program.threads == 0)
    owed_stop_.add(-1);
}

void Pump::owe_stop_of_all(const Fault& why) {
  const bool kept_out = why.kind == FaultKind::refused || why.kind == FaultKind::stopped;
  if (!kept_out) owed_stop_.add(-1);
}

void Pump::make_good_the_stop() {
  if (!owed_stop_.any()) return;
  const int axis = owed_stop_.take();
  // What began since, after a restart or from rest, is somebody else's.
  if (!ran_when_lost_ || draft_.restarts != restarts_when_lost_) return;
  const bool alone = axis >= 0 && catalog_.program.threads > 0;  // else a program is what moves it
  if (!(alone ? draft_.axis_moves(axis) : something_runs())) return;
  ways_.notify(
      Notice(Notice::Kind::warning, scheduler_.now(),
             "When the link was lost a jog was held, or a stop was on its way, and it still ran. It is "
             "stopped now."));
  post_stop(Intent(0, intent::Stop(axis)));
}

void Pump::post_stop(Intent intent) {
  auto* lets_go = std::get_if<intent::JogStop>(&intent.body);
  if (lets_go && lets_go->axis < 0) lets_go->axis = jogs_.in_hand().axis;
  release_jogs(intent.body);
  set_fate(intent.id, Fate::pending);
  tell_wire_of_stop(Addressees::one(catalog_.address));
  if (!station_ || !station_->is_open()) {
    set_fate(intent.id, Fate::failed,
             "Stop does not reach the controller: there is no connection. Use its power switch.");
    ++stops_begun_;
    refuse_queued(stopped_first);
    owe_stop(intent.body);
    return publish();
  }
  begin_stop(Addressees::one(catalog_.address));
  asio::co_spawn(scheduler_.executor(), stop_and_report(std::move(intent)), asio::detached);
}

/// A stop in the controller's own words goes as it is, and waits for nothing either.
bool Pump::stops_by_text(const std::string& text) const {
  return connected() && station_ && station_->is_open() && driver_->is_stop(text);
}

/// Also of one that does not get through: nobody's text is to set in motion behind it what it was to stop.
void Pump::tell_wire_of_stop(Addressees whom) {
  if (const auto wire = shared_wire()) wire->stop_said(whom);
}

std::shared_ptr<Link> Pump::shared_wire() const { return ways_.open_link ? ways_.open_link() : nullptr; }

/// What waits here goes on behind a stop of others only.
void Pump::begin_stop(Addressees whom) {
  const auto own = Addressees::one(catalog_.address);
  const bool here = !whom.any() || whom.share(own);
  if (here) drop_what_waits();
  if (here && station_) station_->being_stopped = true;
  ++stops_under_way_;
}

void Pump::drop_what_waits() {
  ++stops_begun_;
  refuse_queued(stopped_first);
  if (station_) station_->begin_stop();
}

void Pump::end_stop() {
  --stops_under_way_;
  if (stops_under_way_ == 0 && station_) station_->being_stopped = false;
  next_poll_ = scheduler_.now();
  fast_polls_ = fast_polls_after_a_command;
  publish();
  wake_.notify();
  ended_.notify();
}

Task<> Pump::perform_stop_text(Intent intent) {
  count_program_change(intent);
  const std::string& text = std::get<intent::SendText>(intent.body).text;
  const bool to_all = std::get<intent::SendText>(intent.body).broadcast;
  const bool all = driver_->stops_all(text), answered = driver_->answers(text) && !to_all;
  Result<> performed;
  try {
    performed = co_await driver_->perform(intent.body);
  } catch (const std::exception& defect) {
    performed = fail(failed_inside("command", defect));
  }
  if (performed)
    set_fate(intent.id, Fate::done);
  else
    set_fate(intent.id, Fate::failed, performed.error().sentence());
  if (!performed && all) owe_stop_of_all(performed.error());
  if (performed && all && !answered) unanswered_stop_ = rounds_begun_;
  end_stop();
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
  const auto* j = std::get_if<intent::JogStop>(&body);
  return driver_->stop_jog(j ? j->axis : -1);
}

Task<> Pump::stop_and_report(Intent intent) {
  const auto* stop = std::get_if<intent::Stop>(&intent.body);
  const int of_all = stop && stop->axis < 0 ? 1 : 0;
  stops_of_all_ += of_all;
  try {
    auto stopped = co_await stop_as_asked(intent.body);
    if (stopped)
      set_fate(intent.id, Fate::done);
    else
      set_fate(intent.id, Fate::failed, stopped.error().sentence());
    if (!stopped) owe_stop(intent.body);
  } catch (const std::exception& defect) {
    set_fate(intent.id, Fate::failed, fmt::format("The stop failed inside: {}.", defect.what()));
  }
  stops_of_all_ -= of_all;
  end_stop();
}

Task<Result<std::string>> Pump::query_stop(std::string text, Duration patience) {
  begin_stop(driver_->meant_for(intent::SendText(text)));
  count_program_change(Intent(0, intent::SendText(text)));
  const bool all = driver_->stops_all(text), answered = driver_->answers(text);
  ++answers_awaited_;
  bool out = false;
  const auto said = [this, all, &out] {
    if (std::exchange(out, true)) return;
    if (all) unanswered_stop_ = rounds_begun_;
    end_stop();
  };
  Result<std::string> reply;
  try {
    reply = co_await driver_->query_stop(text, patience, said);
  } catch (const std::exception& defect) {
    reply = fail(failed_inside("question", defect));
  }
  if (!reply && !out && all) owe_stop_of_all(reply.error());
  if (reply && !out && all && !answered) unanswered_stop_ = rounds_begun_;
  --answers_awaited_;
  if (!out) end_stop();
  ended_.notify();
  co_return reply;
}

}  // namespace hw
