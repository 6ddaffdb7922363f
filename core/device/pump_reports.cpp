// The reports of a pump: the outcome of each command, the snapshots, and the findings of the status rounds.
#include <algorithm>

#include <fmt/core.h>

#include "core/device/pump_job.h"
#include "core/device/refusals.h"
#include "core/device/travel_check.h"

namespace hw {

void Pump::report_loss() {
  std::string report = outage_.report_when_back(catalog_, snapshot_, something_runs(), scheduler_.now());
  if (!report.empty()) callbacks_.notify(Notice(Notice::Kind::warning, scheduler_.now(), std::move(report)));
}

void Pump::watch_counts() {
  const std::uint32_t set = counts_.look(snapshot_);
  for (int axis = 0; set != 0 && axis < snapshot_.axis_count; ++axis) {
    if ((set >> axis & 1u) == 0) continue;
    pump_log().debug("{}: the count of axis {} was set elsewhere, to {} now", LogName{catalog_}, axis + 1,
                     snapshot_.axes[axis].commanded().value);
    snapshot_.axes[axis].trust.doubt(Doubt::another, scheduler_.now());
    callbacks_.notify(
        Notice(Notice::Kind::warning, scheduler_.now(), describe_count_was_set(catalog_, axis)));
  }
  if (set != 0) publish();
}

/// A command that may move an axis or set a count is sent, or was sent.
void Pump::disturbed() {
  counts_.disturbed();
  endings_.disturbed();
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
  if (std::exchange(snapshot_.store_count, writes_used) != writes_used && runs()) publish();
}

// ---- reports

void Pump::set_outcome(IntentId id, IntentState outcome, std::string_view sentence) {
  IntentOutcome report;
  report.id = id;
  report.state = outcome;
  if (outcome == IntentState::failed) report.kind = FaultKind::controller;
  report.sentence = sentence;
  set_outcome(report);
}

void Pump::set_outcome(const IntentOutcome& report) {
  if (report.state == IntentState::refused || report.state == IntentState::failed)
    pump_log().debug("{}: command {} not done: {}", LogName{catalog_}, report.id, report.sentence.view());
  if (report.id == 0) return;
  auto& outcomes = snapshot_.outcomes;
  auto at = std::find_if(outcomes.begin(), outcomes.end(),
                         [&](const IntentOutcome& f) { return f.id == report.id; });
  if (at == outcomes.end()) {  // settled outcomes are dropped before pending ones
    const auto over = std::find_if(outcomes.rbegin(), outcomes.rend(), [](const IntentOutcome& f) {
      return f.id == 0 || f.state != IntentState::pending;
    });
    const auto room = over == outcomes.rend() ? outcomes.end() - 1 : over.base() - 1;
    std::move_backward(outcomes.begin(), room, room + 1);
    at = outcomes.begin();
  }
  *at = report;
}

void Pump::report_fault(IntentId id, const Fault& fault, IntentOutcome report) {
  report.id = id;
  report.asks = fault.kind == FaultKind::asks;
  report.state = report.asks || fault.kind == FaultKind::refused ? IntentState::refused : IntentState::failed;
  report.set_fault(fault);
  set_outcome(report);
}

/// Computed from the positions of the axes before the text is sent.
std::optional<PastTravel> Pump::past_travel_of_words(const Job& job) {
  const auto* typed = std::get_if<intent::SendText>(&job.intent.body);
  if ((!typed && !job.is_query) || job.meaning.only_asks ||
      job.meaning.addressee == TextMeaning::For::another)
    return {};
  return past_travel_of_text(typed ? typed->text : job.text);
}

std::optional<PastTravel> Pump::past_travel_of_text(const std::string& text) {
  constexpr std::size_t longest = 65'536;  // a stop must not wait for the reading of a longer one
  if (!some_travel_holds(snapshot_) || text.size() > longest) return {};
  TextGoals goals = driver_->goals_of(text);
  if (goals.runs >= 0) {
    const std::vector<AxisTarget> more = loaded_.places_of(goals.runs, snapshot_);
    goals.places.insert(goals.places.end(), more.begin(), more.end());
  }
  auto past = past_travel(catalog_, snapshot_, intent::MoveTo(std::move(goals.places)));
  if (past) past->of = PastTravel::Of::text;
  return past;
}

/// Warns of an axis that goes, or will go, past the user's limit.
void Pump::warn_of(const std::optional<PastTravel>& past) {
  if (!past) return;
  Notice notice(Notice::Kind::warning, scheduler_.now(),
                describe_warned(catalog_, *past, words_in_steps(catalog_, snapshot_).position));
  notice.past = past;
  callbacks_.notify(std::move(notice));
}

void Pump::publish() {
  ++snapshot_.sequence;
  snapshot_.at = scheduler_.now();
  keep_will();
  snapshot_.link.jog_ends = station_ ? station_->jog_ends() : JogEnds::never;
  endings_.look(snapshot_);
  warn_of(travel_.look(snapshot_));
  callbacks_.publish(snapshot_);
  published_.notify();
}

}  // namespace hw
