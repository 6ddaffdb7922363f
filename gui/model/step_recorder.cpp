#include "gui/model/step_recorder.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/core.h>

namespace hw::gui {
namespace {

constexpr std::size_t most_runs = 8;
constexpr Millis arming_time{300};  // longest time from the first sample to the step
constexpr Millis pause_time{300}, patience{2000};
constexpr Millis longest_frame{1000};  // after a longer frame the panel was not looked at

}  // namespace

// ---- the user's commands

std::string_view StepRecorder::why_not(AxisId axis, const View& view) const {
  if (!view.now.link.connected()) return "There is no link.";
  if (records()) return "A step is being recorded.";
  if (const std::string_view why = view.why_not_move(axis); !why.empty()) return why;
  if (view.now.axes[axis.index].activity == Activity::moving)
    return "The axis is moving. Wait until it rests.";
  return {};
}

void StepRecorder::record(const Plan& plan, const View& view) {
  series_ = {};
  begin(plan, 0, view);
}

void StepRecorder::repeat(const Plan& plan, const View& view) {
  series_ = {.on = true};
  begin(plan, -1, view);
}

void StepRecorder::learn_scatter(const Plan& plan, const View& view) {
  results_.scatter = {};
  series_ = {.on = true, .learns_scatter = true};
  begin(plan, 2 * StepScatter::enough, view);
}

void StepRecorder::begin(const Plan& plan, int steps, const View& view) {
  if (plan.length_ms != plan_.length_ms || std::abs(plan.step.value) != std::abs(plan_.step.value))
    results_.scatter = {};
  plan_ = plan;
  step_.sign = 1;
  series_.steps_left = steps;
  frame_.stopped = false;
  request(view);
}

void StepRecorder::end_where_it_began() {
  const bool stands = stage_ == Stage::pausing, leads_away = step_.sign > 0;
  series_.learns_scatter = false;
  series_.steps_left = (stands ? 0 : 1) + (leads_away == stands ? 0 : 1);
  if (series_.steps_left == 0) end_series({});
}

void StepRecorder::forget_runs() {
  results_.runs.clear();
  results_.scatter = {};
  results_.measured_number = 0;
}

// ---- one step

/// The step waits for the first sample, so that the recording shows the initial position.
void StepRecorder::request(const View& view) {
  stage_ = Stage::idle;
  if (const std::string_view why = why_not(plan_.axis, view); !why.empty()) {
    series_ = {};
    return report(Severity::fault, std::string(why));
  }
  results_.runs.emplace_back(++step_.number, plan_.axis, Steps(step_.sign * plan_.step.value));
  step_.span = {};
  step_.before = {view.now.link.timeouts, view.now.restarts};
  step_.move = newest_ =
      view.send(intent::Sample(plan_.axis, Millis(std::llround(plan_.length_ms)) + arming_time));
  stage_ = Stage::arming;
  step_.since = view.clock;
}

void StepRecorder::make_step(const View& view) {
  step_.move = newest_ =
      view.send(intent::MoveBy({AxisTarget{plan_.axis, Steps(step_.sign * plan_.step.value)}}));
  stage_ = Stage::recording;
}

void StepRecorder::take(const AxisSample& sample) {
  if (!records() || sample.axis != plan_.axis.index || results_.runs.empty()) return;
  if (!std::exchange(step_.span.any, true)) step_.span.first = sample.at;
  step_.span.last = sample.at;
  results_.runs.back().take(sample);
}

void StepRecorder::drop_run() {
  results_.runs.pop_back();
  stage_ = Stage::idle;
}

void StepRecorder::finish(const View& view) {
  stage_ = Stage::idle;
  if (!results_.runs.back().moved()) {
    const bool none = results_.runs.back().empty();
    drop_run();
    series_ = {};
    return report(Severity::fault, none ? "No sample arrived: nothing was recorded."
                                        : "The axis was not moved: nothing was recorded.");
  }
  results_.runs.back().end(plan_.length_ms);
  results_.measured = measure(results_.runs.back());
  results_.measured_number = results_.runs.back().number();
  while (results_.runs.size() > most_runs) results_.runs.pop_front();
  if (!series_.on || ended_early(view)) return;
  if (series_.steps_left > 0) --series_.steps_left;
  count_into_scatter();
  if (series_.steps_left == 0) return end_series({});
  step_.sign = -step_.sign;
  stage_ = Stage::pausing;
  step_.since = view.clock;
}

/// Counts only steps away from the start; steps back begin elsewhere. A step with a gap is repeated.
void StepRecorder::count_into_scatter() {
  if (!series_.learns_scatter) return;
  if (step_.sign > 0 && results_.measured.gaps == 0)
    results_.scatter.take(results_.measured);
  else if (step_.sign > 0 && series_.spare > 0)
    --series_.spare, series_.steps_left += 2;
  if (series_.steps_left > 0) return;
  if (results_.scatter.known())
    report(Severity::ok,
           "Three repetitions are measured: a difference within their scatter counts as the same.");
  else
    report(Severity::warn,
           "Repeat the step three times again: the recordings have gaps, so their scatter is unknown.");
}

// ---- frame by frame

bool StepRecorder::was_away(const View& view) {
  const bool frames_missed = !std::exchange(frame_.seen, false);
  return view.clock - std::exchange(frame_.at, view.clock) > longest_frame || frames_missed;
}

/// The event since a step was requested that forbids the next one.
std::string_view StepRecorder::interruption(const View& view, bool away) const {
  if (away) return "another panel was in front";
  const auto& link = view.now.link;
  if (link.state != LinkState::good || link.timeouts != step_.before.timeouts)
    return "the controller did not answer for a while";
  if (view.now.restarts != step_.before.restarts) return "the controller was reset";
  return {};
}

void StepRecorder::follow(const View& view) {
  const bool away = was_away(view), stopped = std::exchange(frame_.stopped, false);
  if (stage_ == Stage::idle) return;
  const std::string_view between = interruption(view, away);
  // After a stop between the request for samples and the step, the step is not made.
  if (stage_ == Stage::arming && (stopped || asked_by_others(view) || !between.empty())) {
    drop_run();
    const bool others = stopped || asked_by_others(view);
    return end_series(
        fmt::format("The step was not made: {}.", others ? "another command came first" : between));
  }
  follow_series(view, between, stopped);
  if (stage_ == Stage::idle) return;  // the series has ended between two steps
  if (stage_ == Stage::pausing) return pause(view);
  if (stage_ == Stage::arming && step_.span.any) make_step(view);
  const IntentOutcome* outcome = view.now.outcome_of(step_.move);
  if (outcome && (outcome->state == IntentState::refused || outcome->state == IntentState::failed)) {
    report(Severity::fault, std::string(outcome->sentence.view()));
    series_ = {};
    return drop_run();
  }
  const Duration length = from_seconds(plan_.length_ms / 1000);
  const bool whole = step_.span.any && step_.span.last - step_.span.first >= length;
  if (whole || view.clock - step_.since > length + patience) finish(view);
}

/// Any other event ends a series for good: a stop, another sender's command, a refusal, a lost link, a reset,
/// another panel in front.
void StepRecorder::follow_series(const View& view, std::string_view between, bool stopped) {
  if (!series_.on) return;
  if (stopped)
    end_series("Stopped: Repeat is off.");
  else if (!between.empty())
    end_series(fmt::format("Repeat is off: {}.", between));
  else if (asked_by_others(view))
    end_series("Repeat is off: the controller received another command.");
}

void StepRecorder::pause(const View& view) {
  const bool settles = view.now.axis_moves(plan_.axis.index);
  if (!series_.on)
    stage_ = Stage::idle;
  else if (view.clock - step_.since > pause_time && !settles && !ended_early(view))
    request(view);
}

void StepRecorder::end_series(std::string_view why) {
  series_ = {};
  if (stage_ == Stage::pausing) stage_ = Stage::idle;
  if (!why.empty()) report(Severity::plain, std::string(why));
}

/// A step that has not settled is the subject of the tuning, and ends nothing.
bool StepRecorder::ended_early(const View& view) {
  const EndedBy ended = view.now.axes[plan_.axis.index].ended_by;
  if (ended == EndedBy::target || ended == EndedBy::nothing || ended == EndedBy::not_in_place) return false;
  end_series("Repeat is off: the axis was stopped before its target.");
  return true;
}

}  // namespace hw::gui
