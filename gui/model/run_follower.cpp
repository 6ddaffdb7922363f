#include "gui/model/run_follower.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hw::gui {

static bool under_way(const ProgramState& p) {
  return p.owned && p.slot >= 0 && p.run != RunState::idle && p.run != RunState::error;
}

/// Programs that run in threads share one text; one of the threads starts first.
static int started(const Snapshot& now, const ProgramFacts& facts) {
  for (int n = 0; n < std::min(facts.threads, max_threads); ++n)
    if (now.threads[static_cast<std::size_t>(n)].run == RunState::running) return n;
  return now.program.slot;
}

void RunFollower::follow(const Snapshot& now, const BenchView& bench, Instant clock,
                         const ProgramTexts& texts, const Language* language, Worker& worker) {
  program_ = now.program;
  if (!under_way(program_)) {
    following_ = false;
    at_rest_ = now;
    return;
  }
  if (!following_ || started_at_ != program_.started_at) {
    following_ = true;
    started_at_ = seen_at_ = program_.started_at;
    seen_run_ = RunState::running;
    run_s_ = 0;
    of_run_.reset();
    ++run_number_;
    if (language) begin(now, bench, texts, *language, worker);
  }
  if (!texts.lines_known(program_.slot)) of_run_.reset();  // the rehearsal is of another program
  if (seen_run_ == RunState::running) run_s_ += std::max(0.0, seconds(clock - seen_at_));
  seen_run_ = program_.run;
  seen_at_ = clock;
  if (program_.run == RunState::held && program_.command >= 0) put_right(program_);
}

void RunFollower::begin(const Snapshot& now, const BenchView& bench, const ProgramTexts& texts,
                        const Language& language, Worker& worker) {
  const HeldProgram& held = texts.held(now.program.slot);
  if (!held.known || held.text.empty()) return;
  auto state = std::make_shared<ControllerState>(ControllerState{at_rest_.value_or(now), {}});
  for (int slot = 0; slot < texts.count(); ++slot)
    if (texts.held(slot).known) state->programs[slot] = texts.held(slot).text;
  RehearseOptions options = rehearse_from(std::move(state), bench, catalog_);
  options.slot = started(now, catalog_.program);
  worker.run([&language, text = held.text,
              options = std::move(options)] { return language.rehearse(text, options); },
             [this, run = run_number_](Result<Rehearsal> result) {
               if (run == run_number_ && result && !result->events.empty()) of_run_ = std::move(*result);
             },
             alive_);
}

// Sets the run time to the nearest time at which the rehearsal reaches the command before which the
// controller is held.
void RunFollower::put_right(const ProgramState& reported) {
  const Rehearsal* r = rehearsal();
  if (!r) return;
  double nearest = run_s_, least = 1e18;
  for (const RehearsedEvent& event : r->events)
    if (event.slot == reported.slot && event.command == reported.command &&
        std::fabs(event.t - run_s_) < least) {
      least = std::fabs(event.t - run_s_);
      nearest = event.t;
    }
  run_s_ = nearest;
}

/// A command without a visible event, such as a delay, may have had its turn since.
void RunFollower::see_turns(const Rehearsal& r, double since, Place& place) const {
  const auto after = std::upper_bound(r.turns.begin(), r.turns.end(), run_s_,
                                      [](double t, const RehearsedTurn& turn) { return t < turn.t; });
  if (after != r.turns.begin()) {
    const RehearsedTurn& turn = *std::prev(after);
    if (turn.t > since || (turn.t == since && place.slot == program_.slot))
      place.slot = program_.slot, place.command = turn.command;
  }
  if (after == r.turns.end()) return;
  const double next = after->t - run_s_;
  place.next_in_s = place.next_in_s > 0 ? std::min(place.next_in_s, next) : next;
}

/// Counts turns, where known: several events may happen in one pass.
void RunFollower::count_passes(const Rehearsal& r, Place& place) const {
  const auto count = [&](double t) {
    ++place.passes;
    if (t <= run_s_ + 1e-6) ++place.pass;
  };
  if (place.slot == program_.slot)
    for (const RehearsedTurn& turn : r.turns)
      if (turn.command == place.command) count(turn.t);
  if (place.passes == 0)
    for (const RehearsedEvent& event : r.events)
      if (event.slot == place.slot && event.command == place.command) count(event.t);
  if (!r.finished) place.passes = 0;
}

RunFollower::Place RunFollower::place() const {
  Place place;
  if (!following_) return place;
  const Rehearsal* r = rehearsal();
  if (program_.command >= 0) {
    place.slot = program_.slot;
    place.command = program_.command;
  } else if (r && run_s_ <= r->duration_s) {
    const auto after = std::upper_bound(r->events.begin(), r->events.end(), run_s_,
                                        [](double t, const RehearsedEvent& event) { return t < event.t; });
    double since = -1;
    for (auto at = after; at != r->events.begin();) {
      --at;
      if (at->command < 0) continue;
      place.slot = at->slot;
      place.command = at->command;
      since = at->t;
      break;
    }
    if (after != r->events.end()) place.next_in_s = after->t - run_s_;
    see_turns(*r, since, place);
  }
  if (r && place.command >= 0) count_passes(*r, place);
  return place;
}

std::optional<double> RunFollower::left_s() const {
  const Rehearsal* r = rehearsal();
  if (!following_ || !r || !r->finished || run_s_ > r->duration_s) return {};
  return r->duration_s - run_s_;
}

}  // namespace hw::gui
