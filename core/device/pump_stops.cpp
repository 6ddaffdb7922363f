// Stops of an open controller, as intents or as typed text. A stop ends the procedure under way and takes its
// place. It is sent again until its effect shows, and before anything else when a lost wire is back.
#include <fmt/core.h>

#include "core/device/axis_check.h"
#include "core/device/pump_job.h"

namespace hw {
namespace {

constexpr int attempts_in_a_row = 3;
constexpr std::string_view no_way =
    "Use the controller's power switch: Stop cannot reach it without a connection.";

Fault not_answered() {
  return Fault(FaultKind::no_answer, "Stop was sent, but the controller does not answer.",
               "The stop is sent again until it does.", "If it moves, use its power switch.");
}

}  // namespace

void Pump::post_stop(StopOrder order) {
  if (order.axis >= static_cast<int>(catalog_.axes.size())) {
    set_outcome(order.intent, IntentState::refused, describe_no_axis(order.axis));
    return publish();
  }
  if (order.what == StopOrder::What::jog && order.axis < 0) order.axis = jogs_.in_hand().axis;
  release_jogs(order);
  set_outcome(order.intent, IntentState::pending);
  const bool another = order.what == StopOrder::What::words && !order.meaning.stops_here();
  const StopOrder& asked = ask(std::move(order));
  pump_log().debug("{}: {} requested{}", LogName{catalog_}, asked,
                   another ? "" : "; waiting commands are dropped, and the command under way ends");
  if (!another) drop_waiting_jobs();
  const StopOrder* sending = desk_.sending();
  if (station_ && !(sending && sending->outlasts(asked))) station_->preempt();
  outage_.retry_at_once_for_stop();
  publish();
  wake_.notify();
}

/// A stop that ends cutting also switches the tool off, right after it.
StopOrder& Pump::ask(StopOrder order) {
  using What = StopOrder::What;
  const bool leaves_tool =
      order.what == What::jog || (order.what == What::words && !order.meaning.stops_here());
  endings_.stop_asked(order, snapshot_, order.asked_at == Instant{} ? scheduler_.now() : order.asked_at);
  StopOrder& asked = desk_.ask(std::move(order));
  if (!leaves_tool) pieces_.end();
  if (leaves_tool || !tool_.may_be_on(snapshot_)) return asked;
  tool_.forget_hold();
  pump_log().debug("{}: the tool is switched off after {}", LogName{catalog_}, asked);
  desk_.ask_tool(tool_.outputs());
  return asked;
}

/// Commands queued before a stop are never sent after it, neither here nor as a broadcast.
void Pump::drop_waiting_jobs() {
  refuse_queued(stopped_first);
  if (!callbacks_.line) return;
  callbacks_.line->begin_epoch();
  callbacks_.line->for_each_but(*this, [](Pump& other) {
    if (other.jobs_.performs_for_all_on_the_wire() && other.station_) other.station_->preempt();
  });
}

bool Pump::stop_wire(bool at_once) {
  if (!station_ || !station_->is_open()) return false;
  StopOrder order;
  order.what = StopOrder::What::broadcast;
  order.at_once = at_once;
  ask(std::move(order));
  station_->preempt();
  wake_.notify();
  return true;
}

// The order may be withdrawn meanwhile, when the wire is lost.
Task<> Pump::send_stop(StopOrder& order) {
  ++order.times_sent;
  order.sent_at = scheduler_.now();
  if (order.times_sent == 1) order.first_sent_at = order.sent_at;
  endings_.stop_goes_out(order, order.sent_at);
  pump_log().debug("{}: {} is sent, time {}", LogName{catalog_}, order, order.times_sent);
  if (order.what == StopOrder::What::words)
    count_program_change(Intent(order.intent, intent::SendText(order.words)));
  order.in_haste = desk_.another_waits(order);
  const StopOrder sending = order;
  desk_.begin_sending(sending);
  auto sent = co_await guarded("stop", driver_->stop(sending));
  desk_.end_sending();
  if (station_) station_->stop_was_sent();
  if (StopOrder* still = desk_.find(sending.number)) stop_was_sent(*still, std::move(sent));
  if (connected() && sending.times_sent >= attempts_in_a_row && is_silent()) lose_wire(not_answering());
  publish();
}

void Pump::stop_was_sent(StopOrder& order, Result<std::string> sent) {
  using What = StopOrder::What;
  const bool cut = !sent && sent.error().kind == FaultKind::stopped;
  if (order.what == What::broadcast) {
    if (!sent && !cut)
      callbacks_.notify(Notice(Notice::Kind::error, scheduler_.now(), sent.error().sentence()));
    return close_stop(order);
  }
  if (order.what == What::words) {  // sent once, as typed
    if (sent && (!order.meaning.stops_here() || order.meaning.answered == TextMeaning::Answered::at_once)) {
      if (order.answer) std::exchange(order.answer, nullptr)(std::move(sent));
      set_outcome(order.intent, IntentState::done);
      return close_stop(order);
    }
    order.sent = order.confirmed = sent.has_value();
    order.reported = true;
    if (sent)
      set_outcome(order.intent, IntentState::done);
    else
      set_outcome(order.intent, IntentState::failed, sent.error().sentence());
    if (order.answer)
      std::exchange(order.answer, nullptr)(sent ? std::move(sent) : Result<std::string>(fail(sent.error())));
    if (sent) return;
    if (sent.error().kind != FaultKind::refused) follow_words(order);  // kept out
    return close_stop(order);
  }
  if (cut) {  // it is due again after the stop that cut it short
    pump_log().debug("{}: {} was cut short by another stop and is due again", LogName{catalog_}, order);
    return;
  }
  order.confirmed = sent.has_value();
  const bool connected_now = connected();
  const bool tool = order.what == What::tool;  // not repeated in a row: a stop of motion may be needed first
  order.sent = sent || tool || order.times_sent >= attempts_in_a_row || !connected_now;
  if (sent) return;
  if (tool) --order.times_sent;  // only a stop that was sent counts
  const bool no_such_program = order.what == What::program && sent.error().kind == FaultKind::refused;
  if (no_such_program || (order.sent && connected_now && !is_silent())) stop_failed(order, sent.error());
  if (no_such_program) close_stop(order);
}

/// If a typed stop may not have arrived, the console's own stop of the same scope follows, until its effect
/// shows.
void Pump::follow_words(const StopOrder& words) {
  pump_log().debug("{}: \"{}\" may not have arrived: the console's own stop follows", LogName{catalog_},
                   log::Bytes{words.words});
  StopOrder own;
  own.intent = words.intent;
  own.reported = true;
  own.by = words.by;
  own.times_sent = words.times_sent;
  own.sent_at = words.sent_at, own.first_sent_at = words.first_sent_at;
  const TextMeaning& meaning = words.meaning;
  if (meaning.stops == TextMeaning::Stops::all) ask(own).at_once = false;
  for (int axis = 0; axis < snapshot_.axis_count; ++axis) {
    if (meaning.axis != axis && (meaning.axes >> axis & 1u) == 0) continue;
    own.axis = axis;
    ask(own).at_once = false;  // the console's repetition ramps as the first did
  }
}

/// The tool waits until every stop has taken effect, and for one more status round.
void Pump::look_at_stops() {
  auto& orders = desk_.orders();
  const bool tool_shows = desk_.only_tool();
  for (auto at = orders.begin(); at != orders.end();) {
    StopOrder& order = *at++;
    if (order.what == StopOrder::What::tool && !order.confirmed) order.sent = false;
    if (order.sent && (order.what != StopOrder::What::tool || tool_shows)) look_at_stop(order);
  }
}

void Pump::look_at_stop(StopOrder& order) {
  const bool tool = order.what == StopOrder::What::tool;
  StopProgress progress = tool ? tool_.progress(order, snapshot_) : driver_->stop_progress(order);
  if (progress.now == StopProgress::Now::wait && !order.confirmed) progress = StopProgress::again();
  switch (progress.now) {
    case StopProgress::Now::wait: return;
    case StopProgress::Now::at_once:
      pump_log().debug("{}: {} continues at once, without a ramp", LogName{catalog_}, order);
      order.at_once = true;
      [[fallthrough]];
    case StopProgress::Now::again:
      pump_log().debug("{}: {} shows no effect", LogName{catalog_}, order);
      order.sent = order.confirmed = false;
      if (order.what == StopOrder::What::words)
        order.what = StopOrder::What::everything;  // a typed text is sent once
      return;
    case StopProgress::Now::failed:
      if (progress.why) stop_failed(order, *progress.why);
      if (progress.why && tool)
        callbacks_.notify(Notice(Notice::Kind::error, scheduler_.now(), progress.why->sentence()));
      if (tool) tool_.give_up();
      return close_stop(order);
    case StopProgress::Now::stands:
      if (!order.reported) set_outcome(order.intent, IntentState::done);
      return close_stop(order);
  }
}

void Pump::stop_failed(StopOrder& order, const Fault& why) {
  pump_log().debug("{}: {} failed: {}", LogName{catalog_}, order, why.what);
  if (order.answer) std::exchange(order.answer, nullptr)(fail(why));
  if (!std::exchange(order.reported, true)) set_outcome(order.intent, IntentState::failed, why.sentence());
}

void Pump::close_stop(StopOrder& order) {
  pump_log().debug("{}: {} is over", LogName{catalog_}, order);
  desk_.close(order);
  rounds_.look_often(scheduler_.now());
  wake_.notify();
}

/// Notifies the requesters; motions that may still run are stopped as soon as there is a wire. `why`: the
/// reason that there is no connection, if known.
void Pump::stops_did_not_arrive(const Fault* why) {
  for (StopOrder& order : desk_.orders()) {
    const bool sent = order.times_sent > 0;
    const Fault reported = !sent ? Fault(FaultKind::lost, std::string(no_way)) : why ? *why : not_answered();
    stop_failed(order, reported);
  }
  publish();
}

void Pump::keep_stops_at_loss(const Fault& why, bool drew_together) {
  using What = StopOrder::What;
  stops_did_not_arrive(outage_.may_run() ? nullptr : &why);
  desk_.orders().remove_if([this](const StopOrder& order) {
    const bool other =
        order.what == What::broadcast || (order.what == What::words && !order.meaning.stops_here());
    return !outage_.may_run() || other;
  });
  for (const StopOrder& order : desk_.orders())
    pump_log().debug("{}: {} stays pending until the link is back", LogName{catalog_}, order);
  const bool tool = tool_.at_work();
  if ((tool || drew_together) && !desk_.stops_all()) {  // the other controllers do not continue either
    StopOrder ends;
    ends.reported = true;
    ask(std::move(ends)).at_once = false;
    if (tool)
      callbacks_.notify(Notice(
          Notice::Kind::warning, scheduler_.now(),
          "The link was lost while a program with a tool was running. Use the power switch of the tool: the "
          "console can stop everything and switch the tool off only when the link is back."));
  }
  jogs_.for_each_axis([this](int axis) {
    StopOrder lets_go;
    lets_go.what = StopOrder::What::jog;
    lets_go.axis = axis;
    lets_go.reported = true;
    desk_.ask(std::move(lets_go));
    if (axis >= 0) snapshot_.link.when_lost.axes |= 1u << axis;  // the motion may not have been seen yet
  });
  desk_.send_all_again();
}

/// Another session on the wire sends this broadcast now.
void Pump::note_broadcast(const std::string& text, const TextMeaning& meaning) {
  pump_log().debug("{}: \"{}\" was sent to all devices on the wire{}", LogName{catalog_}, log::Bytes{text},
                   meaning.is_stop() ? ", a stop" : "");
  past_by_broadcast_ = meaning.is_stop() ? std::nullopt : past_travel_of_text(text);
  words_come_between(meaning);
  if (meaning.is_stop()) {
    if (meaning.stops == TextMeaning::Stops::all) {  // the next rounds show whether it was received here
      StopOrder order;
      order.sent = order.reported = true;
      order.by = StoppedBy::text;
      order.times_sent = 1;
      order.sent_at = order.first_sent_at = scheduler_.now();
      ask(std::move(order)).at_once = false;
    } else {
      desk_.note_another();
    }
    refuse_queued(stopped_first);
    if (station_) station_->preempt();
  }
  disturbed();
  driver_->note_broadcast(text);
  if (meaning.runs_program) tool_.program_may_run(snapshot_);
  if (meaning.changes_programs) {
    loaded_.forget();
    ++snapshot_.program_changes;
    snapshot_.program_changed_by = 0;
  }
  wake_.notify();
}

/// The broadcast of another session has been performed, or was not `sent`.
void Pump::broadcast_was_sent(bool sent) {
  disturbed();
  if (sent) warn_of(past_by_broadcast_);
  past_by_broadcast_.reset();
}

Task<Result<std::string>> Pump::query_stop(std::string text, TextMeaning meaning, Duration patience) {
  const Asking asking(*this);
  struct Asked {
    Suspended waiting_procedure;
    std::optional<Result<std::string>> reply;
  };
  const auto asked = std::make_shared<Asked>();
  StopOrder order;
  order.what = StopOrder::What::words;
  order.words = std::move(text);
  order.by = StoppedBy::text;
  order.meaning = meaning;
  order.axis = meaning.axis;
  order.patience = patience;
  order.answer = [this, asked](Result<std::string> reply) {
    asked->reply = std::move(reply);
    asked->waiting_procedure.resume(scheduler_.executor());
  };
  const std::uint64_t since = texts_.next();
  post_stop(std::move(order));
  const std::uint64_t epoch = desk_.epoch();
  while (!asked->reply) co_await asked->waiting_procedure.here();
  auto& reply = *asked->reply;
  if (!reply || meaning.answered != TextMeaning::Answered::later) co_return std::move(reply);
  co_return co_await add_late_replies(std::move(*reply), since, epoch, patience);
}

}  // namespace hw
