// What is asked of an open controller: commands and questions in their order, and jogs. Stops:
// pump_stops.cpp.
#include <algorithm>

#include <fmt/core.h>

#include "core/device/pump_job.h"
#include "core/device/refusals.h"

namespace hw {
namespace {

constexpr std::size_t most_queued = 64;

/// What is usually asked for in order to start a program next.
bool leads_to_a_start(const IntentBody& body) {
  return std::holds_alternative<intent::LoadProgram>(body) ||
         std::holds_alternative<intent::UploadProgram>(body);
}

}  // namespace

void Pump::post(Intent intent) {
  if (std::holds_alternative<intent::JogKeepAlive>(intent.body)) {
    if (jogs_.any() && dead_man_.armed()) dead_man_.arm(scheduler_.now() + dead_man);
    return;
  }
  const bool lets_go = std::holds_alternative<intent::JogStop>(intent.body);
  if (lets_go && (!jogs_.any_guarded() || (withdraw_waiting_jog() && !jogs_.any_guarded()))) {
    // Released twice, a jog that was refused, or one whose turn had not come. A second stop would mean: at
    // once, without a ramp.
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
  if (leaving_) {
    set_fate(intent.id, Fate::refused, "The controller was closed. Nothing was sent.");
    return publish();
  }
  const auto* text = std::get_if<intent::SendText>(&intent.body);
  set_fate(intent.id, Fate::pending);
  if (text && driver_->is_stop(text->text)) tell_wire_of_stop(driver_->meant_for(*text));
  if (text && stops_by_text(text->text)) {
    begin_stop(driver_->meant_for(*text));
    asio::co_spawn(scheduler_.executor(), perform_stop_text(std::move(intent)), asio::detached);
    return;
  }
  if (queue_.size() >= most_queued) {
    set_fate(intent.id, Fate::refused, "Too many commands wait already. This one was not sent.");
    return publish();
  }
  hold_jog(intent);
  if (text && !connected() && driver_->stops_all(text->text)) owed_stop_.add(-1);
  const bool recovers = text && try_to_recover(text->text);
  auto job = std::make_unique<Job>(std::move(intent));
  job->recovers = recovers;
  enqueue(std::move(job));
}

void Pump::enqueue(std::unique_ptr<Job> job) {
  const auto* text = std::get_if<intent::SendText>(&job->intent.body);
  if (const auto wire = shared_wire(); wire && text)
    job->stops_before = wire->stops_said(driver_->meant_for(*text));
  queue_.push_back(std::move(job));
  wake_.notify();
}

/// A text that a silent controller may yet take is said in the attempt to connect: in the one under way, or
/// in one that is made now.
bool Pump::try_to_recover(const std::string& text) {
  const bool lost = draft_.link.state == LinkState::lost;
  if (!lost && draft_.link.state != LinkState::connecting) return false;
  if (!driver_->recover_by(text)) return false;
  recovering_ = true;
  retry_now_ = retry_now_ || lost;
  return true;
}

/// What was said while the connection was made is not said again.
void Pump::answer_recovery() {
  auto reply = driver_->take_recovery();
  if (!reply || queue_.empty() || !queue_.front()->recovers) return;
  std::unique_ptr<Job> job = std::move(queue_.front());
  queue_.pop_front();
  set_fate(job->intent.id, Fate::done);
  if (!job->is_query) return;
  job->reply = std::move(*reply);
  job->answered = true;
  job->asker.resume(scheduler_.executor());
  job.release();  // its asker owns it from here
}

void Pump::hold_jog(const Intent& intent) {
  const auto* jog = std::get_if<intent::JogStart>(&intent.body);
  if (!jog) return;
  jogs_.begin(intent.id, jog->axis.index, jog->dead_man);
  if (jog->dead_man) dead_man_.arm(scheduler_.now() + dead_man);
}

// Halting one of several threads leaves the motion alone, and a stop of one axis the others: what else is
// held stays guarded.
void Pump::release_jogs(const IntentBody& stop) {
  if (std::holds_alternative<intent::HaltProgram>(stop) && catalog_.program.threads > 0) return;
  if (const auto* s = std::get_if<intent::Stop>(&stop))
    jogs_.stop(s->axis);
  else if (const auto* a = std::get_if<intent::Abort>(&stop))
    jogs_.stop(a->axis);
  else if (const auto* j = std::get_if<intent::JogStop>(&stop))
    jogs_.stop(j->axis);
  else
    jogs_.stop(-1);
  disarm_if_none_is_held();
}

void Pump::disarm_if_none_is_held() {
  if (!jogs_.any_guarded()) dead_man_.disarm();
}

/// The hand's jog, if it still waits for its turn: it has moved nothing, so nothing is stopped.
bool Pump::withdraw_waiting_jog() {
  const auto waits = std::find_if(queue_.begin(), queue_.end(), [this](const auto& job) {
    return std::holds_alternative<intent::JogStart>(job->intent.body) && job->intent.id == jogs_.in_hand().id;
  });
  if (waits == queue_.end()) return false;
  const Intent jog = (*waits)->intent;
  queue_.erase(waits);
  jog_not_begun(jog);
  set_fate(jog.id, Fate::refused, "It was let go before its turn came. Nothing was sent.");
  return true;
}

void Pump::jog_not_begun(const Intent& intent) {
  if (!std::holds_alternative<intent::JogStart>(intent.body)) return;
  jogs_.end(intent.id);
  disarm_if_none_is_held();
}

/// A script does not let go of what a limit has ended; nothing else is to be stopped in its name.
void Pump::forget_jogs_that_ended() {
  jogs_.forget_if([this](IntentId id, int axis) {
    const bool waits =
        std::any_of(queue_.begin(), queue_.end(), [id](const auto& job) { return job->intent.id == id; });
    const Activity activity = draft_.axes[axis].activity;
    return !waits && activity != Activity::jogging && activity != Activity::unknown;
  });
}

/// One that may have begun although nobody can tell is stopped: its hand has been told of the failure, and
/// will not stop it. It is stopped by its axis, so that nothing else is.
void Pump::jog_failed(const Intent& intent, FaultKind kind) {
  const auto* jog = std::get_if<intent::JogStart>(&intent.body);
  if (!jog || !jogs_.has(intent.id)) return;
  const bool rejected =
      kind == FaultKind::refused || kind == FaultKind::stopped || kind == FaultKind::controller;
  if (rejected) return jog_not_begun(intent);
  ways_.notify(Notice(Notice::Kind::warning, scheduler_.now(),
                      "Whether the jog has begun is not known, so the axis was told to stop."));
  intent::JogStop lets_go;
  lets_go.axis = jog->axis.index;
  post_stop(Intent(0, lets_go));
}

void Pump::jog_let_go() {
  ways_.notify(Notice(Notice::Kind::warning, scheduler_.now(),
                      "The console did not hold the jog any more, so the axis was stopped."));
  post_stop(Intent(0, intent::JogStop()));
}

void Pump::refuse_queued(std::string_view why) {
  if (queue_.empty()) return;
  for (auto& job : std::exchange(queue_, {})) refuse(std::move(job), why);
  publish();
}

void Pump::refuse(std::unique_ptr<Job> job, std::string_view why) {
  set_fate(job->intent.id, Fate::refused, why);
  jog_not_begun(job->intent);
  if (!job->is_query) return;
  job->reply = fail(FaultKind::refused, std::string(why));
  job->answered = true;
  job->asker.resume(scheduler_.executor());
  job.release();  // its asker owns it from here
}

// Whoever has its own idea of the programs in the controller hears that others may have changed them.
void Pump::count_program_change(const Intent& intent) {
  const IntentBody& body = intent.body;
  const auto* raw = std::get_if<intent::SendText>(&body);  // a question too
  const bool changes = raw ? driver_->changes_programs(raw->text)
                           : std::holds_alternative<intent::LoadProgram>(body) ||
                                 std::holds_alternative<intent::ClearProgram>(body) ||
                                 std::holds_alternative<intent::Reset>(body);
  if (!changes) return;
  ++draft_.program_changes;
  draft_.program_changed_by = intent.id;
}

void Pump::tell_fault(IntentId id, const Fault& fault, std::uint32_t doubtful) {
  IntentFate told;
  told.id = id;
  told.asks = fault.kind == FaultKind::asks;
  told.fate = told.asks || fault.kind == FaultKind::refused ? Fate::refused : Fate::failed;
  told.sentence = fault.sentence();
  told.doubtful = doubtful;
  set_fate(told);
}

Result<> Pump::trust_position(AxisId axis) {
  if (axis.index >= catalog_.axes.size())
    return fail(FaultKind::refused, fmt::format("There is no axis {}.", axis.index + 1));
  AxisState& state = draft_.axes[axis.index];
  if (!state.position_known)
    return fail(FaultKind::refused,
                fmt::format("The position of {} is not known, so it cannot be taken for true.",
                            spoken_name(catalog_, axis.index)),
                {}, "Home it, or set its position.");
  state.trust.settle(Trust::set, scheduler_.now());
  return {};
}

Task<> Pump::perform_next() {
  std::unique_ptr<Job> job = std::move(queue_.front());
  queue_.pop_front();
  station_->stops_before = job->stops_before;
  performing_ = true;
  count_program_change(job->intent);
  if (job->is_query) {
    try {
      job->reply = co_await driver_->query(job->text, job->patience);
    } catch (const std::exception& defect) {  // whoever asked waits for it
      job->reply = fail(failed_inside("question", defect));
    }
    job->answered = true;
    performing_ = false;
    job->asker.resume(scheduler_.executor());
    job.release();  // its asker owns it from here
    co_return;
  }
  Result<> performed;
  // What no driver is asked for: see refusals.h.
  const std::uint32_t doubtful = doubtful_axes(catalog_, draft_, job->intent.body);
  const std::uint64_t stops_before = stops_begun_;
  try {
    if (doubtful != 0)
      performed = fail(FaultKind::refused, say_doubtful(catalog_, draft_, job->intent.body, doubtful,
                                                        words_in_steps(catalog_, draft_)));
    else if (const int torn = torn_program(catalog_, draft_, job->intent.body); torn >= 0)
      performed = fail(FaultKind::refused, say_torn(catalog_, torn));
    else if (const auto* wish = std::get_if<intent::TrustPosition>(&job->intent.body))
      performed = trust_position(wish->axis);
    else
      performed = co_await driver_->perform(job->intent.body);
  } catch (const std::exception& defect) {
    performed = fail(failed_inside("command", defect));
  }
  performing_ = false;
  if (const auto* read = std::get_if<intent::UploadProgram>(&job->intent.body); read && performed)
    draft_.slots_torn = static_cast<std::uint8_t>(draft_.slots_torn & ~torn_bit(catalog_, read->slot));
  if (performed && stops_begun_ != stops_before && leads_to_a_start(job->intent.body))
    performed = fail(FaultKind::stopped, "A stop came while this was under way.", "It is whole.",
                     "Nothing follows it: ask again for what should.");
  if (performed)
    set_fate(job->intent.id, Fate::done);
  else
    tell_fault(job->intent.id, performed.error(), doubtful);
  if (!performed) jog_failed(job->intent, performed.error().kind);
  publish();
}

Task<Result<std::string>> Pump::query(std::string text, Duration patience) {
  if (leaving_) co_return fail(FaultKind::refused, "The controller was closed.", "Nothing was sent.");
  const bool recovers = try_to_recover(text);
  const bool lost = draft_.link.state == LinkState::lost || draft_.link.state == LinkState::closed;
  if (!connected() && driver_->stops_all(text)) owed_stop_.add(-1);
  if (driver_->is_stop(text)) tell_wire_of_stop(driver_->meant_for(intent::SendText(text)));
  if (!recovers && lost)
    co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
  if (stops_by_text(text)) co_return co_await query_stop(std::move(text), patience);
  auto owned = std::make_unique<Job>(Intent(0, intent::SendText(text)));
  Job* job = owned.get();
  job->is_query = true;
  job->recovers = recovers;
  job->text = std::move(text);
  job->patience = patience;
  enqueue(std::move(owned));
  while (!job->answered) co_await job->asker.here();
  std::unique_ptr<Job> mine(job);
  co_return std::move(mine->reply);
}

}  // namespace hw
