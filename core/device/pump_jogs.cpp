// Held jogs of an open controller: begun, kept alive, released, and stopped when they are no longer held or
// seen.
#include <fmt/core.h>

#include "core/device/pump_job.h"

namespace hw {

void Pump::hold_jog(const Intent& intent) {
  const auto* jog = std::get_if<intent::JogStart>(&intent.body);
  if (jog) jogs_.begin(intent.id, jog->axis.index, jog->dead_man);
}

/// Leaves the last will just before a held jog is sent, and takes it back when the stop of the jog is over. A
/// jog that waits for its turn has no will: it moves nothing yet.
void Pump::keep_will() {
  const bool has_wire = station_ && station_->is_open();
  const unsigned held = jogs_.guarded_axes_if([this](IntentId id) { return !jobs_.has(id); });
  will_->follow(held, desk_.any(), has_wire ? station_.get() : nullptr);
}

// Halting one of several threads does not affect motion, and a stop of one axis does not affect the others:
// other held jogs stay guarded.
void Pump::release_jogs(const StopOrder& order) {
  using What = StopOrder::What;
  const TextMeaning& meaning = order.meaning;
  if (order.what == What::program && catalog_.program.threads > 0) return;
  if (order.what == What::words && !meaning.stops_here()) return;
  if (order.what != What::words) return jogs_.stop(order.what == What::program ? -1 : order.axis);
  if (meaning.stops == TextMeaning::Stops::all) return jogs_.stop(-1);
  for (int axis = 0; axis < snapshot_.axis_count; ++axis)
    if (axis == meaning.axis || (meaning.axes >> axis & 1u) != 0) jogs_.stop(axis);
}

/// Withdraws the user's jog if it still waits for its turn. It has moved nothing, so no stop is sent.
bool Pump::withdraw_waiting_jog() {
  const auto jog = jogs_.any_guarded() ? jobs_.withdraw(jogs_.in_hand().id) : nullptr;
  if (!jog) return false;
  jog_not_begun(jog->intent);
  set_outcome(jog->intent.id, IntentState::refused,
              "The button was released while the jog was still queued. Nothing was sent.");
  return true;
}

void Pump::jog_not_begun(const Intent& intent) {
  if (std::holds_alternative<intent::JogStart>(intent.body)) jogs_.end(intent.id);
}

/// A script does not release a jog that a limit has ended; its release must not stop a later motion.
void Pump::forget_jogs_that_ended() {
  jogs_.forget_if([this](IntentId id, int axis) {
    const Activity activity = snapshot_.axes[axis].activity;
    return !jobs_.has(id) && activity != Activity::jogging && activity != Activity::unknown;
  });
}

/// A jog that may have begun is stopped: its requester was notified of the failure, and will not stop it. The
/// stop is for its axis, so that nothing else is stopped.
void Pump::jog_failed(const Intent& intent, FaultKind kind) {
  const auto* jog = std::get_if<intent::JogStart>(&intent.body);
  if (!jog || !jogs_.has(intent.id)) return;
  const bool rejected =
      kind == FaultKind::refused || kind == FaultKind::stopped || kind == FaultKind::controller;
  if (rejected) return jog_not_begun(intent);
  pump_log().debug("{}: command {}: the jog may have begun, so it is stopped", LogName{catalog_}, intent.id);
  callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(),
                           "A stop is being sent to the axis, because the jog may have begun."));
  StopOrder lets_go;
  lets_go.what = StopOrder::What::jog;
  lets_go.axis = jog->axis.index;
  post_stop(std::move(lets_go));
}

void Pump::jog_let_go() {
  pump_log().debug("{}: the jog was not kept alive for {} ms", LogName{catalog_},
                   dead_man.count() / 1'000'000);
  callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(),
                           "The jog was no longer held, so a stop is being sent."));
  StopOrder lets_go;
  lets_go.what = StopOrder::What::jog;
  post_stop(std::move(lets_go));
}

// Held jogs whose axes are no longer seen are stopped. A jog that still waits for its turn moves nothing.
void Pump::stop_unseen_jogs() {
  for (const int axis : jogs_.axes_if([this](IntentId id) { return !jobs_.has(id); })) {
    pump_log().debug("{}: {} answers were missed: the jog of axis {} is stopped", LogName{catalog_},
                     station_->statistics().misses_in_a_row, axis + 1);
    callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(),
                             "The controller does not answer, so a stop is being sent."));
    StopOrder lets_go;
    lets_go.what = StopOrder::What::jog;
    lets_go.axis = axis;
    post_stop(std::move(lets_go));
  }
}

}  // namespace hw
