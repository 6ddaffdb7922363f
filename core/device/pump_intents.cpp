// Commands and questions to an open controller, in their order. Jogs: pump_jogs.cpp. Raw texts with a reply:
// pump_queries.cpp. Stops: pump_stops.cpp.
#include <algorithm>

#include <fmt/core.h>

#include "core/device/axis_check.h"
#include "core/device/backlash_moves.h"
#include "core/device/homing.h"
#include "core/device/pump_job.h"
#include "core/device/refusals.h"

namespace hw {
namespace {

/// Intents that usually precede the start of a program.
bool leads_to_a_start(const IntentBody& body) {
  return std::holds_alternative<intent::LoadProgram>(body) ||
         std::holds_alternative<intent::UploadProgram>(body);
}

/// Intents about a position: valid only for the controller as it was when the user sent them.
bool states_position(const IntentBody& body) {
  return std::holds_alternative<intent::SetPosition>(body) ||
         std::holds_alternative<intent::SetEncoder>(body) ||
         std::holds_alternative<intent::TrustPosition>(body) ||
         std::holds_alternative<intent::RecallPositions>(body);
}

bool restarts_it(const Job& job) {
  return std::holds_alternative<intent::Reset>(job.intent.body) || job.meaning.restarts;
}

}  // namespace

void Pump::post(Intent intent) {
  if (std::holds_alternative<intent::JogKeepAlive>(intent.body)) {
    jogs_.keep_alive();
    return;
  }
  const bool lets_go = std::holds_alternative<intent::JogStop>(intent.body);
  if (lets_go && (!jogs_.any_guarded() || (withdraw_waiting_jog() && !jogs_.any_guarded()))) {
    // The jog was released twice, was refused, or had not begun.
    set_outcome(intent.id, IntentState::done);
    return publish();
  }
  if (auto stop = stop_order_of(intent)) return post_stop(std::move(*stop));
  if (std::holds_alternative<intent::Reconnect>(intent.body)) {
    outage_.retry_at_once();
    set_outcome(intent.id, IntentState::done);
    wake_.notify();
    return;
  }
  if (const auto* request = std::get_if<intent::SetTravel>(&intent.body))
    return set_travel(intent.id, *request);
  if (const auto* request = std::get_if<intent::SetBacklash>(&intent.body))
    return set_backlash(intent.id, *request);
  if (std::holds_alternative<intent::SendText>(intent.body)) return post_text(std::move(intent));
  if (leaves()) {
    set_outcome(intent.id, IntentState::refused, was_closed);
    return publish();
  }
  set_outcome(intent.id, IntentState::pending);
  if (jobs_.full()) {
    set_outcome(intent.id, IntentState::refused, queue_is_full);
    return publish();
  }
  hold_jog(intent);
  enqueue(std::make_unique<Job>(std::move(intent)));
}

// On a shared wire a text goes to the session of the device that it names, and waits for its turn there.
void Pump::post_text(Intent intent) {
  const auto& text = std::get<intent::SendText>(intent.body);
  const TextMeaning meaning = driver_->meaning_of(text);
  set_outcome(intent.id, IntentState::pending);
  if (meaning.addressee == TextMeaning::For::another && callbacks_.line) {
    if (Pump* other = callbacks_.line->at(meaning.address)) {
      pump_log().debug("{}: \"{}\" is for device {:02}: passed to its session", LogName{catalog_},
                       log::Bytes{text.text}, meaning.address);
      asio::co_spawn(scheduler_.executor(), pass_on(std::move(intent), *other), asio::detached);
      return;
    }
  }
  if (meaning.is_stop()) {
    if (meaning.addressee == TextMeaning::For::all && callbacks_.line)
      callbacks_.line->for_each_but(*this, [&](Pump& other) { other.note_broadcast(text.text, meaning); });
    StopOrder order;
    order.what = StopOrder::What::words;
    order.words = text.text;
    order.by = StoppedBy::text;
    order.meaning = meaning;
    order.axis = meaning.axis;
    order.intent = intent.id;
    return post_stop(std::move(order));
  }
  if (leaves()) {
    set_outcome(intent.id, IntentState::refused, was_closed);
    return publish();
  }
  if (jobs_.full()) {
    set_outcome(intent.id, IntentState::refused, queue_is_full);
    return publish();
  }
  auto job = std::make_unique<Job>(std::move(intent));
  job->meaning = meaning;
  enqueue(std::move(job));
}

/// Passes a text to the session of the device that it names; the answer is shown where the text was typed.
Task<> Pump::pass_on(Intent intent, Pump& other) {
  constexpr Duration usual_patience = Millis(200);
  const Asking asking(*this);
  const std::string text = std::get<intent::SendText>(intent.body).text;
  const auto record = [this](Way way, const std::string& bytes) {
    if (!callbacks_.traffic) return;
    callbacks_.traffic->push_in_place([&](TrafficEntry& entry) {
      entry.at = scheduler_.now();
      entry.way = way;
      entry.kind = TrafficKind::intent;
      entry.bytes = bytes;
    });
    if (callbacks_.recorded) callbacks_.recorded();
  };
  record(Way::sent, text);
  auto reply = co_await other.query(text, usual_patience);
  if (reply && !reply->empty()) {
    record(Way::received, *reply);
    texts_.add(*reply);
  }
  if (reply)
    set_outcome(intent.id, IntentState::done);
  else
    report_fault(intent.id, reply.error());
  publish();
}

void Pump::enqueue(std::unique_ptr<Job> job) {
  if (callbacks_.line) job->line_epoch = callbacks_.line->epoch();
  job->restarts_before = snapshot_.restarts;
  job->first_round = tool_.is_seen_before(job->intent.body) ? rounds_.want(scheduler_.now()) : 0;
  jobs_.push(std::move(job));
  wake_.notify();
}

void Pump::refuse_queued(std::string_view why) {
  if (jobs_.empty()) return;
  pump_log().debug("{}: the waiting commands are dropped: {}", LogName{catalog_}, why);
  for (auto& job : jobs_.take_all()) refuse(std::move(job), why);
  publish();
}

void Pump::refuse(std::unique_ptr<Job> job, std::string_view why) {
  set_outcome(job->intent.id, IntentState::refused, why);
  jog_not_begun(job->intent);
  if (!job->is_query) return;
  job->reply = fail(FaultKind::refused, std::string(why));
  job->answered = true;
  job->waiting_procedure.resume(scheduler_.executor());
  job.release();  // the waiting procedure owns it from here
}

// Users of a copy of the controller's programs are notified that the programs may have changed.
void Pump::count_program_change(const Intent& intent) {
  const IntentBody& body = intent.body;
  const auto* raw = std::get_if<intent::SendText>(&body);  // a question too
  const bool changes = raw ? driver_->meaning_of(*raw).changes_programs
                           : std::holds_alternative<intent::LoadProgram>(body) ||
                                 std::holds_alternative<intent::ClearProgram>(body) ||
                                 std::holds_alternative<intent::GuardJogs>(body) ||
                                 std::holds_alternative<intent::Reset>(body);
  if (!changes) return;
  loaded_.forget(body);
  ++snapshot_.program_changes;
  snapshot_.program_changed_by = intent.id;
}

Result<> Pump::trust_position(AxisId axis) {
  if (axis.index >= catalog_.axes.size())  // nothing would be sent anyway
    return fail(FaultKind::refused, describe_no_axis(axis.index));
  AxisState& state = snapshot_.axes[axis.index];
  if (!state.position_known)
    return fail(FaultKind::refused,
                fmt::format("The position of {} is not known, so it cannot be confirmed.",
                            spoken_name(catalog_, axis.index)),
                {}, "Home it, or set its position.");
  state.trust.settle(Trust::set, scheduler_.now());
  return {};
}

void Pump::recall_positions(const std::vector<KeptPosition>& kept) {
  for (std::size_t i = 0; i < kept.size() && static_cast<int>(i) < snapshot_.axis_count; ++i) {
    AxisState& axis = snapshot_.axes[i];
    const bool nothing_better = axis.trust == PositionTrust();
    if (!axis.position_known || !nothing_better) {
      pump_log().debug("{}: the kept position of axis {} is not used: {}", LogName{catalog_}, i + 1,
                       axis.position_known ? "a better count is known" : "its count is not known");
      continue;
    }
    axis.trust = recalled(kept[i], axis.commanded(), scheduler_.now());
  }
}

/// At once, also without a connection: waiting commands are checked against the new limits.
void Pump::set_travel(IntentId id, const intent::SetTravel& request) {
  const std::string why_not =
      describe_no_travel(catalog_, request, words_in_steps(catalog_, snapshot_).position);
  if (why_not.empty()) snapshot_.axes[request.axis.index].travel = request.travel;
  set_outcome(id, why_not.empty() ? IntentState::done : IntentState::refused, why_not);
  publish();
}

void Pump::set_backlash(IntentId id, const intent::SetBacklash& request) {
  const std::string why_not = describe_no_backlash(request, catalog_.axes.size());
  if (why_not.empty()) snapshot_.axes[request.axis.index].backlash = request.backlash;
  set_outcome(id, why_not.empty() ? IntentState::done : IntentState::refused, why_not);
  publish();
}

/// The place from which backlash is taken up must lie within the limits too.
Result<> Pump::take_up_backlash(IntentBody& body, IntentOutcome& report) const {
  auto in_two = with_backlash_taken_up(snapshot_, body);
  if (!in_two) return {};
  report.past = past_travel(catalog_, snapshot_, *in_two->pieces->all[0].does[0].what);
  if (report.past) {
    report.past->of = PastTravel::Of::backlash;
    return fail(FaultKind::refused,
                describe_past(catalog_, *report.past, words_in_steps(catalog_, snapshot_).position));
  }
  pump_log().debug("{}: command {}: the move is made in two parts, to take up backlash", LogName{catalog_},
                   report.id);
  body = std::move(*in_two);
  return {};
}

/// Refuses intents before the driver is asked, see refusals.h and travel_check.h, and bounds jogs by the
/// limits. `report` receives the values for a sentence in other units.
Result<> Pump::admit(Job& job, IntentOutcome& report) {
  IntentBody& body = job.intent.body;
  const auto steps = words_in_steps(catalog_, snapshot_);
  if (states_position(body) && job.restarts_before != snapshot_.restarts)
    return fail(FaultKind::refused, "The controller was switched off and on after this command was given.",
                "Nothing was sent.", "Check the position of the axes, then give the command again.");
  if (const auto* home = std::get_if<intent::Home>(&body))
    if (auto possible = check_home(catalog_, *home); !possible) return possible;
  if (auto* run = std::get_if<intent::RunProgram>(&body); run && run->places.empty() && !run->despite_doubt)
    run->places = loaded_.places_in_doubt(run->slot, snapshot_);
  report.doubtful = doubtful_axes(catalog_, snapshot_, body);
  if (report.doubtful != 0)
    return fail(FaultKind::refused, describe_doubtful(catalog_, snapshot_, body, report.doubtful, steps));
  if (const int torn = torn_program(catalog_, snapshot_, body); torn >= 0)
    return fail(FaultKind::refused, describe_torn(catalog_, torn));
  report.past = past_travel(catalog_, snapshot_, body);
  if (auto* jog = std::get_if<intent::JogStart>(&body)) report.past = bound_by_travel(snapshot_, *jog);
  if (report.past) return fail(FaultKind::refused, describe_past(catalog_, *report.past, steps.position));
  return take_up_backlash(body, report);
}

/// Refuses a broadcast that was queued before a stop of one of the controllers, or while one is being
/// stopped.
Result<> Pump::may_go_to_all(const Job& job) const {
  if (job.meaning.addressee != TextMeaning::For::all || !callbacks_.line) return {};
  if (callbacks_.line->epoch() != job.line_epoch) return fail(stop_came_first());
  bool one_is_stopped = false;
  callbacks_.line->for_each_but(*this, [&](Pump& other) { one_is_stopped |= other.desk_.any(); });
  if (!one_is_stopped) return {};
  return fail(FaultKind::refused, "One of the devices addressed is being stopped.",
              "The command was not sent.", "Send it again when that device has stopped.");
}

/// Not for a refused text: it did not reach the controller. Returns whether it may have been sent.
bool Pump::words_were_sent(const Job& job, const Result<>& performed, const std::optional<PastTravel>& past) {
  const bool words = job.is_query || std::holds_alternative<intent::SendText>(job.intent.body);
  const Fault* fault = nullptr;
  if (!performed) fault = &performed.error();
  if (job.is_query && !job.reply) fault = &job.reply.error();
  const bool sent = !fault || fault->kind != FaultKind::refused;
  if (!words || !sent || job.meaning.addressee == TextMeaning::For::another) return sent;
  words_come_between(job.meaning);
  warn_of(past);
  return sent;
}

Task<> Pump::perform_next() {
  std::unique_ptr<Job> job = jobs_.begin();
  keep_will();
  count_program_change(job->intent);
  IntentOutcome report;
  const std::uint64_t epoch = desk_.epoch();
  const std::uint32_t restarts = snapshot_.restarts;
  const std::optional<PastTravel> past = past_travel_of_words(*job);
  Result<> performed = may_go_to_all(*job);
  const bool to_all = performed && jobs_.performs_for_all_on_the_wire() && callbacks_.line;
  if (to_all)
    callbacks_.line->for_each_but(*this, [&](Pump& other) {
      other.note_broadcast(std::get<intent::SendText>(job->intent.body).text, job->meaning);
    });
  const auto* run = std::get_if<intent::RunProgram>(&job->intent.body);
  if (run) endings_.program_starts(run->slot, scheduler_.now());
  if (performed && job->meaning.runs_program) tool_.program_may_run(snapshot_);
  if (performed && job->is_query) {
    job->since = texts_.next();
    job->reply = co_await guarded("question", driver_->query(job->text, job->patience));
  } else if (!performed && job->is_query) {
    job->reply = fail(performed.error());
  } else if (auto admitted = admit(*job, report); performed && !admitted) {
    performed = std::move(admitted);
  } else if (const auto* request = std::get_if<intent::TrustPosition>(&job->intent.body)) {
    performed = trust_position(request->axis);
  } else if (const auto* memory = std::get_if<intent::RecallPositions>(&job->intent.body)) {
    recall_positions(memory->kept);
  } else if (performed) {
    performed = co_await perform_beside_pieces(job->intent.body);
  }
  const bool sent = words_were_sent(*job, performed, past);
  if (to_all) callbacks_.line->for_each_but(*this, [sent](Pump& other) { other.broadcast_was_sent(sent); });
  if (run && !performed) endings_.disturbed();
  jobs_.end();
  if (!performed) driver_log(catalog_).debug("{}: {}", LogName{catalog_}, performed.error().sentence());
  if (performed && snapshot_.restarts != restarts && restarts_it(*job))
    jobs_.restart_was_asked(snapshot_.restarts);
  if (job->is_query) {
    job->answered = true;
    job->waiting_procedure.resume(scheduler_.executor());
    job.release();  // the waiting procedure owns it from here
    co_return;
  }
  if (const auto* load = std::get_if<intent::LoadProgram>(&job->intent.body); load && performed)
    loaded_.loaded(*load);
  if (const auto* read = std::get_if<intent::UploadProgram>(&job->intent.body); read && performed)
    snapshot_.slots_torn = static_cast<std::uint8_t>(snapshot_.slots_torn & ~torn_bit(catalog_, read->slot));
  if (performed && desk_.epoch() != epoch && leads_to_a_start(job->intent.body))
    performed =
        fail(FaultKind::stopped, "A stop came while this command was under way.",
             "The command was completed.", "The commands to follow it were dropped: send them again.");
  if (performed)
    set_outcome(job->intent.id, IntentState::done);
  else
    report_fault(job->intent.id, performed.error(), report);
  if (!performed) jog_failed(job->intent, performed.error().kind);
  publish();
}

}  // namespace hw
