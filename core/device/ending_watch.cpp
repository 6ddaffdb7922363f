#include "core/device/ending_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/base/index.h"

namespace hw {
namespace {

/// The longest pause between two motions of one command, such as an approach from one side.
constexpr Duration a_pause = Millis(500);
/// An axis at rest for so long without an explanation is reported as it is.
constexpr Duration longest_unexplained = std::chrono::seconds(2);

/// A program, list or drawing runs, which is reported with its motions at its end.
bool something_reports(const Snapshot& now) {
  const ProgramState& p = now.program;
  const bool program = p.owned && p.run != RunState::idle && p.run != RunState::error;
  const bool thread = std::any_of(now.threads.begin(), now.threads.end(), [](const ThreadState& t) {
    return t.known && t.run != RunState::idle && t.run != RunState::error;
  });
  return program || thread || now.feed.running || now.pieces.running;
}

bool stopped(EndedBy by) { return by == EndedBy::stop || by == EndedBy::abort; }

bool as_meant(EndedBy by) { return by == EndedBy::target || by == EndedBy::nothing; }

bool goes_to_travel_end(const AxisState& axis) {
  if (axis.activity != Activity::jogging || !axis.has_target || !axis.travel_holds()) return false;
  const Travel& t = axis.travel;
  return (t.has_minus && axis.target == t.minus) || (t.has_plus && axis.target == t.plus);
}

Ending::What kind_of_motion(Activity activity) {
  return activity == Activity::homing    ? Ending::What::homing
         : activity == Activity::jogging ? Ending::What::jog
                                         : Ending::What::motion;
}

}  // namespace

bool EndingWatch::stops_axis(const StopOrder& order, int axis) {
  using What = StopOrder::What;
  if (order.what == What::tool || (order.what == What::words && !order.meaning.stops_here())) return false;
  const bool all = order.stops_all() || order.what == What::broadcast;
  return all || order.axis == axis || (order.what == What::words && (order.meaning.axes >> axis & 1u) != 0);
}

void EndingWatch::stop_asked(const StopOrder& order, const Snapshot& now, Instant at) {
  using What = StopOrder::What;
  if (order.what == What::tool || (order.what == What::words && !order.meaning.stops_here())) return;
  for (int i = 0; i < max_axes; ++i) {
    if (!stops_axis(order, i)) continue;
    ways_.stopped(i);
    Run& run = axes_[ix(i)];
    run.stopped_by = order.by;
    if (!run.under_way || run.asked_at != Instant{}) continue;
    const AxisState& axis = now.axes[ix(i)];
    const double since_seen = seconds(at - axis.seen_at) * axis.speed.value * axis.direction;
    run.asked_at = at;
    run.asked_place = axis.position + Steps(std::llround(since_seen));
    run.asked_speed = axis.speed;
  }
  if (order.what == What::jog) return;
  const bool one_axis = order.what == What::everything && order.axis >= 0 && catalog_.program.threads > 0;
  if (one_axis) return;  // the program continues
  ways_.disturbed();
  for (int i = 0; i < max_threads; ++i)
    if ((order.thread < 0 || order.thread == i) && !threads_[ix(i)].over)
      threads_[ix(i)].stopped_by = order.by;
  if (!program_.over) program_.stopped_by = order.by;
  list_.stopped_by = order.by;
  if (order.by != StoppedBy::unknown)
    pieces_.stopped_by = order.by;  // else the stop only ends pieces that are over
  if (order.what == What::program)
    for (Run& axis : axes_) axis.stopped_by = order.by;
}

void EndingWatch::stop_goes_out(const StopOrder& order, Instant at) {
  for (int i = 0; i < max_axes; ++i)
    if (Run& run = axes_[ix(i)]; run.sent_at == Instant{} && stops_axis(order, i)) run.sent_at = at;
}

/// Judged by the distance between two readings, if it is long enough.
bool EndingWatch::falls_behind(Run& run, const AxisState& axis) {
  constexpr double plainly = 0.8, enough_steps = 20;
  const bool behind_stop = run.sent_at != Instant{} && run.seen_at >= run.sent_at;
  if (behind_stop && run.pace * seconds(axis.seen_at - run.seen_at) < enough_steps) return false;
  const Instant before = std::exchange(run.seen_at, axis.seen_at);
  const Steps from = std::exchange(run.seen_place, axis.position);
  const double way = std::abs(static_cast<double>((axis.position - from).value));
  const double time = seconds(axis.seen_at - before);
  if (before == Instant{} || time <= 0) return false;
  if (run.sent_at == Instant{}) run.pace = way / time;
  return behind_stop && way < plainly * run.pace * time;
}

// Judged by the status, the speed or the positions alone, whichever the controller reports.
void EndingWatch::see_slowing(Run& run, const AxisState& axis) {
  constexpr double plainly = 0.98;
  const bool behind = axis.seen_at != run.seen_at && falls_behind(run, axis);
  if (run.sent_at == Instant{} || run.slow_at != Instant{} || axis.seen_at < run.sent_at) return;
  const bool slower = axis.speed.value > 0 && axis.speed.value < plainly * run.asked_speed.value;
  if (axis.phase == Phase::decelerating || slower || behind) run.slow_at = axis.seen_at;
}

void EndingWatch::time_the_stop(Run& run, Instant at) {
  if (run.asked_at == Instant{} || run.sent_at == Instant{} || !run.ending.place_known) return;
  run.ending.timed = true;
  run.ending.to_wire = run.sent_at - run.asked_at;
  run.ending.to_rest = at - run.asked_at;
  if (run.slow_at != Instant{}) run.ending.to_slowing = run.slow_at - run.asked_at;
  run.ending.ran_on = Steps(std::abs((run.ending.place - run.asked_place).value));
}

void EndingWatch::look(const Snapshot& now) {
  if (!report_) return;
  for (const Ending& motion : ways_.look(now)) report_(motion);
  for (int i = 0; i < now.axis_count; ++i) look_at_axis(now, i);
  if (catalog_.program.threads > 0)
    look_at_threads(now);
  else
    look_at_program(now);
  look_at_list(now);
  look_at_pieces(now);
}

void EndingWatch::begin(Run& run, Ending::What what, Instant now) {
  run = Run();
  run.under_way = true;
  run.ending.what = what;
  run.ending.began = now;
}

void EndingWatch::finish(Run& run, Instant at) {
  run.under_way = run.over = false;
  if (stopped(run.ending.by)) run.ending.stopped_by = run.stopped_by, time_the_stop(run, at);
  if (run.quiet && as_meant(run.ending.by)) return;
  run.ending.at = at;
  report_(run.ending);
}

void EndingWatch::look_at_axis(const Snapshot& now, int axis) {
  Run& run = axes_[ix(axis)];
  const AxisState& state = now.axes[ix(axis)];
  if (now.axis_moves(axis)) {
    const bool another = run.rests_since != Instant{} && state.seen_at - run.rests_since > a_pause;
    if (!run.under_way || another) begin(run, kind_of_motion(state.activity), now.at);
    run.rests_since = {};
    if (state.activity != Activity::stopping) run.ending.what = kind_of_motion(state.activity);
    run.ending.at_travel_end = goes_to_travel_end(state);
    run.quiet = something_reports(now);
    run.ending.of_run = run.ending.of_run || run.quiet;
    see_slowing(run, state);
    return;
  }
  if (!run.under_way) return;
  const bool lost_its_place = state.trust.doubtful() && state.trust.since >= run.ending.began;
  const bool restarted = state.ended_by == EndedBy::lost && lost_its_place;
  if (state.activity == Activity::unknown && !restarted) {  // decided when the axis answers again
    run.rests_since = {};
    return;
  }
  // The cause of the end may show a round later, or never.
  const bool explained = state.ended_by != EndedBy::nothing || state.activity == Activity::error;
  if (!explained && run.rests_since == Instant{}) run.rests_since = state.seen_at;
  if (!explained && state.seen_at - run.rests_since < longest_unexplained) return;
  run.quiet = run.quiet || something_reports(now);
  run.ending.axis = axis;
  run.ending.at_travel_end = run.ending.at_travel_end && state.ended_by == EndedBy::target;
  run.ending.by = state.activity == Activity::error && state.ended_by == EndedBy::nothing ? EndedBy::error
                                                                                          : state.ended_by;
  const bool by_text = run.stopped_by == StoppedBy::text && run.sent_at != Instant{};
  if (by_text && run.ending.by == EndedBy::elsewhere) run.ending.by = EndedBy::stop;
  run.ending.beside_program = something_reports(now);
  run.ending.of_run = run.ending.of_run || run.ending.beside_program;
  if (restarted) run.ending.lost_with = state.trust.cause;
  run.ending.error = state.error;
  run.ending.limit_minus = state.limits_known && state.limit_minus;
  run.ending.limit_plus = state.limits_known && state.limit_plus;
  run.ending.place_known = state.position_known;
  run.ending.place = state.position;
  run.ending.off = state.loop == Loop::none ? Steps() : state.following_error();
  finish(run, now.at);
}

void EndingWatch::look_at_program(const Snapshot& now) {
  const ProgramState& p = now.program;
  const bool runs = p.owned && p.run != RunState::idle && p.run != RunState::error;
  if (program_.over) finish_judged(program_);
  if (runs && now.link.connected()) {
    if (program_.over) finish(program_, program_.ending.at);
    if (!program_.under_way) begin(program_, Ending::What::program, now.at);
    program_.ending.slot = p.slot;
    return;
  }
  if (!program_.under_way || program_.over || !now.link.connected()) return;
  if (p.ended_by == EndedBy::nothing && p.run != RunState::error) return;
  program_.ending.by = p.run == RunState::error ? EndedBy::error : p.ended_by;
  if (program_.ending.by == EndedBy::error) find_cause(program_.ending, now, -1);
  if (program_.ending.by == EndedBy::limit) find_axis_at_limit(program_.ending, now);
  program_.over = true;
  program_.ending.at = now.at;
  finish_judged(program_);
}

/// A program that ran to its end, but whose last motion was cut short, ended with that motion.
void EndingWatch::finish_judged(Run& run) {
  if (ways_.is_judging()) return;
  Ending& ending = run.ending;
  if (const auto& cut = ways_.last_cut(); cut && as_meant(ending.by)) {
    ending.by = cut->by;
    ending.perhaps_limit = cut->perhaps_limit;
    if (cut->by == EndedBy::limit)
      ending.failed_axis = cut->axis,
      ending.error = cut->limit_minus ? AxisError::limit_minus : AxisError::limit_plus;
  }
  finish(run, ending.at);
}

void EndingWatch::look_at_threads(const Snapshot& now) {
  for (int i = 0; i < std::min(catalog_.program.threads, max_threads); ++i) {
    Run& run = threads_[ix(i)];
    const ThreadState& thread = now.threads[ix(i)];
    if (run.over) finish_judged(run);
    if (!thread.known) continue;
    if (thread.run != RunState::idle && thread.run != RunState::error) {
      if (run.over) finish(run, run.ending.at);
      if (!run.under_way) begin(run, Ending::What::program, now.at);
      continue;
    }
    if (!run.under_way || run.over) continue;
    run.ending.slot = i;
    // The controller does not report how one of several threads ended; a stop of this thread is known.
    run.ending.by = thread.run == RunState::error              ? EndedBy::error
                    : run.stopped_by != StoppedBy::unknown     ? EndedBy::stop
                    : stopped(now.program.ended_by)            ? EndedBy::elsewhere
                    : now.program.ended_by == EndedBy::nothing ? EndedBy::target
                                                               : now.program.ended_by;
    if (run.ending.by == EndedBy::error) find_cause(run.ending, now, thread.line);
    run.over = true;
    run.ending.at = now.at;
    finish_judged(run);
  }
}

/// An axis in error stops a program.
void EndingWatch::find_cause(Ending& ending, const Snapshot& now, int line) {
  ending.line = line;
  for (int i = 0; i < now.axis_count && ending.failed_axis < 0; ++i)
    if (now.axes[ix(i)].error != AxisError::none)
      ending.failed_axis = i, ending.error = now.axes[ix(i)].error;
}

void EndingWatch::find_axis_at_limit(Ending& ending, const Snapshot& now) {
  for (int i = 0; i < now.axis_count && ending.failed_axis < 0; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    if (axis.ended_by != EndedBy::limit || !axis.limits_known) continue;
    ending.failed_axis = i;
    ending.error = axis.limit_minus == axis.limit_plus ? AxisError::limit
                   : axis.limit_minus                  ? AxisError::limit_minus
                                                       : AxisError::limit_plus;
  }
}

void EndingWatch::look_at_list(const Snapshot& now) {
  if (now.feed.running) {
    if (!list_.under_way) begin(list_, Ending::What::list, now.at);
    list_.ending.done = now.feed.sent, list_.ending.total = now.feed.total;
    return;
  }
  if (!list_.under_way || now.any_axis_moving() || !now.link.connected()) return;
  list_.ending.done = now.feed.sent;
  list_.ending.by = list_.stopped_by != StoppedBy::unknown ? EndedBy::stop : EndedBy::target;
  finish(list_, now.at);
}

void EndingWatch::look_at_pieces(const Snapshot& now) {
  if (now.pieces.running) {
    if (!pieces_.under_way) begin(pieces_, Ending::What::pieces, now.at);
    pieces_.ending.done = now.pieces.done, pieces_.ending.total = now.pieces.total;
    return;
  }
  if (!pieces_.under_way || now.any_axis_moving() || !now.link.connected()) return;
  pieces_.ending.done = now.pieces.done;
  pieces_.ending.by = pieces_.stopped_by != StoppedBy::unknown     ? EndedBy::stop
                      : pieces_.ending.done < pieces_.ending.total ? EndedBy::elsewhere
                                                                   : EndedBy::target;
  finish(pieces_, now.at);
}

}  // namespace hw
