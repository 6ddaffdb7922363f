// What a pump reports: the outcome of each command, the snapshots, and what the status rounds have shown.
#include <algorithm>

#include <fmt/core.h>

#include "core/device/pump_job.h"
#include "core/device/refusals.h"

namespace hw {

void Pump::tell_what_came_of_the_loss() {
  std::string told = outage_.told_when_back(catalog_, draft_, something_runs(), scheduler_.now());
  if (!told.empty()) callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(), std::move(told)));
}

void Pump::watch_counts() {
  const std::uint32_t set = counts_.look(draft_);
  for (int axis = 0; set != 0 && axis < draft_.axis_count; ++axis) {
    if ((set >> axis & 1u) == 0) continue;
    pump_log().debug("{}: the count of axis {} was set elsewhere, to {} now", Whose{catalog_}, axis + 1,
                     draft_.axes[axis].commanded().value);
    draft_.axes[axis].trust.doubt(Doubt::another, scheduler_.now());
    callbacks_.notify(
        Notice(Notice::Kind::warning, scheduler_.now(), describe_count_was_set(catalog_, axis)));
  }
  if (set != 0) publish();
}

std::uint64_t Pump::want_round() {
  const std::uint64_t wanted = rounds_.want(scheduler_.now());
  wake_.notify();
  return wanted;
}

Task<> Pump::refresh() {
  if (!connected()) co_return;
  const std::uint64_t wanted = want_round();
  while (rounds_.ended() < wanted && connected() && !closes()) co_await published_.wait();
}

void Pump::know_store_count(std::int32_t writes_used) {
  if (std::exchange(draft_.store_count, writes_used) != writes_used && runs()) publish();
}

// ---- what is told

void Pump::set_outcome(IntentId id, IntentState outcome, std::string_view sentence) {
  IntentOutcome told;
  told.id = id;
  told.state = outcome;
  if (outcome == IntentState::failed) told.kind = FaultKind::controller;
  told.sentence = sentence;
  set_outcome(told);
}

void Pump::set_outcome(const IntentOutcome& told) {
  if (told.state == IntentState::refused || told.state == IntentState::failed)
    pump_log().debug("{}: command {} not done: {}", Whose{catalog_}, told.id, told.sentence.view());
  if (told.id == 0) return;
  auto& outcomes = draft_.outcomes;
  auto at =
      std::find_if(outcomes.begin(), outcomes.end(), [&](const IntentOutcome& f) { return f.id == told.id; });
  if (at == outcomes.end()) {  // what still waits is not forgotten for what is over
    const auto over = std::find_if(outcomes.rbegin(), outcomes.rend(), [](const IntentOutcome& f) {
      return f.id == 0 || f.state != IntentState::pending;
    });
    const auto room = over == outcomes.rend() ? outcomes.end() - 1 : over.base() - 1;
    std::move_backward(outcomes.begin(), room, room + 1);
    at = outcomes.begin();
  }
  *at = told;
}

void Pump::report_fault(IntentId id, const Fault& fault, IntentOutcome told) {
  told.id = id;
  told.asks = fault.kind == FaultKind::asks;
  told.state = told.asks || fault.kind == FaultKind::refused ? IntentState::refused : IntentState::failed;
  told.tell(fault);
  set_outcome(told);
}

void Pump::publish() {
  ++draft_.sequence;
  draft_.at = scheduler_.now();
  keep_will();
  draft_.link.jog_ends = station_ ? station_->jog_ends() : JogEnds::by_nobody;
  endings_.look(draft_);
  if (std::string passed = travel_.look(draft_); !passed.empty())
    callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(), std::move(passed)));
  callbacks_.publish(draft_);
  published_.notify();
}

}  // namespace hw
