#include "core/device/ending_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/base/index.h"

namespace hw {
namespace {

/// Something that tells of the motions it makes, at its end.
bool something_tells(const Snapshot& now) {
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

Ending::What what_moves(Activity activity) {
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
    Run& run = axes_[ix(i)];
    run.who = order.by;
    if (!run.under_way || run.asked_at != Instant{}) continue;
    const AxisState& axis = now.axes[ix(i)];
    const double since_seen = seconds(at - axis.seen_at) * axis.speed.value * axis.direction;
    run.asked_at = at;
    run.asked_place = axis.position + Steps(std::llround(since_seen));
    run.asked_speed = axis.speed;
  }
  if (order.what == What::jog) return;
  const bool one_axis = order.what == What::everything && order.axis >= 0 && catalog_.program.threads > 0;
  if (one_axis) return;  // its program goes on
  for (int i = 0; i < max_threads; ++i)
    if (order.thread < 0 || order.thread == i) threads_[ix(i)].who = order.by;
  program_.who = list_.who = order.by;
  if (order.by != StoppedBy::nobody) pieces_.who = order.by;  // else it only ends what is over
  if (order.what == What::program)
    for (Run& axis : axes_) axis.who = order.by;
}

void EndingWatch::stop_goes_out(const StopOrder& order, Instant at) {
  for (int i = 0; i < max_axes; ++i)
    if (Run& run = axes_[ix(i)]; run.sent_at == Instant{} && stops_axis(order, i)) run.sent_at = at;
}

/// By its way between two readings, where that is long enough to judge by.
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

// By its status, its speed, or its way alone: whichever the controller tells.
void EndingWatch::see_slowing(Run& run, const AxisState& axis) {
  constexpr double plainly = 0.98;
  const bool behind = axis.seen_at != run.seen_at && falls_behind(run, axis);
  if (run.sent_at == Instant{} || run.slow_at != Instant{} || axis.seen_at < run.sent_at) return;
  const bool slower = axis.speed.value > 0 && axis.speed.value < plainly * run.asked_speed.value;
  if (axis.phase == Phase::decelerating || slower || behind) run.slow_at = axis.seen_at;
}

void EndingWatch::time_the_stop(Run& run, Instant at) {
  if (run.asked_at == Instant{} || run.sent_at == Instant{} || !run.told.place_known) return;
  run.told.timed = true;
  run.told.to_wire = run.sent_at - run.asked_at;
  run.told.to_rest = at - run.asked_at;
  if (run.slow_at != Instant{}) run.told.to_slowing = run.slow_at - run.asked_at;
  run.told.ran_on = Steps(std::abs((run.told.place - run.asked_place).value));
}

void EndingWatch::look(const Snapshot& now) {
  if (!tell_) return;
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
  run.told.what = what;
  run.told.began = now;
}

void EndingWatch::finish(Run& run, Instant at) {
  run.under_way = false;
  if (stopped(run.told.by)) run.told.who = run.who, time_the_stop(run, at);
  if (run.quiet && as_meant(run.told.by)) return;
  run.told.at = at;
  tell_(run.told);
}

void EndingWatch::look_at_axis(const Snapshot& now, int axis) {
  Run& run = axes_[ix(axis)];
  const AxisState& state = now.axes[ix(axis)];
  if (now.axis_moves(axis)) {
    if (!run.under_way) begin(run, what_moves(state.activity), now.at);
    if (state.activity != Activity::stopping) run.told.what = what_moves(state.activity);
    run.told.at_travel_end = goes_to_travel_end(state);
    run.quiet = something_tells(now);
    see_slowing(run, state);
    return;
  }
  if (!run.under_way) return;
  const bool lost_its_place = state.trust.doubtful() && state.trust.since >= run.told.began;
  const bool restarted = state.ended_by == EndedBy::lost && lost_its_place;
  if (state.activity == Activity::unknown && !restarted) return;  // it shows when the axis is heard again
  // How it ended may show a round later.
  if (state.ended_by == EndedBy::nothing && state.activity != Activity::error) return;
  run.quiet = run.quiet || something_tells(now);
  run.told.axis = axis;
  run.told.at_travel_end = run.told.at_travel_end && state.ended_by == EndedBy::target;
  run.told.by = state.ended_by == EndedBy::nothing ? EndedBy::error : state.ended_by;
  run.told.beside_program = something_tells(now);
  if (restarted) run.told.lost_with = state.trust.cause;
  run.told.error = state.error;
  run.told.limit_minus = state.limits_known && state.limit_minus;
  run.told.limit_plus = state.limits_known && state.limit_plus;
  run.told.place_known = state.position_known;
  run.told.place = state.position;
  run.told.off = state.loop == Loop::none ? Steps() : state.following_error();
  finish(run, now.at);
}

void EndingWatch::look_at_program(const Snapshot& now) {
  const ProgramState& p = now.program;
  const bool runs = p.owned && p.run != RunState::idle && p.run != RunState::error;
  if (runs && now.link.connected()) {
    if (!program_.under_way) begin(program_, Ending::What::program, now.at);
    program_.told.slot = p.slot;
    return;
  }
  if (!program_.under_way || !now.link.connected()) return;
  if (p.ended_by == EndedBy::nothing && p.run != RunState::error) return;
  program_.told.by = p.run == RunState::error ? EndedBy::error : p.ended_by;
  if (program_.told.by == EndedBy::error) find_cause(program_.told, now, -1);
  if (program_.told.by == EndedBy::limit) find_axis_at_limit(program_.told, now);
  finish(program_, now.at);
}

void EndingWatch::look_at_threads(const Snapshot& now) {
  for (int i = 0; i < std::min(catalog_.program.threads, max_threads); ++i) {
    Run& run = threads_[ix(i)];
    const ThreadState& thread = now.threads[ix(i)];
    if (!thread.known) continue;
    if (thread.run != RunState::idle && thread.run != RunState::error) {
      if (!run.under_way) begin(run, Ending::What::program, now.at);
      continue;
    }
    if (!run.under_way) continue;
    run.told.slot = i;
    // How one of several has ended is not told; a stop that was for it is known.
    run.told.by = thread.run == RunState::error              ? EndedBy::error
                  : run.who != StoppedBy::nobody             ? EndedBy::stop
                  : stopped(now.program.ended_by)            ? EndedBy::elsewhere
                  : now.program.ended_by == EndedBy::nothing ? EndedBy::target
                                                             : now.program.ended_by;
    if (run.told.by == EndedBy::error) find_cause(run.told, now, thread.line);
    finish(run, now.at);
  }
}

/// An axis that is in error keeps a program from going on.
void EndingWatch::find_cause(Ending& told, const Snapshot& now, int line) {
  told.line = line;
  for (int i = 0; i < now.axis_count && told.failed_axis < 0; ++i)
    if (now.axes[ix(i)].error != AxisError::none) told.failed_axis = i, told.error = now.axes[ix(i)].error;
}

void EndingWatch::find_axis_at_limit(Ending& told, const Snapshot& now) {
  for (int i = 0; i < now.axis_count && told.failed_axis < 0; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    if (axis.ended_by != EndedBy::limit || !axis.limits_known) continue;
    told.failed_axis = i;
    told.error = axis.limit_minus == axis.limit_plus ? AxisError::limit
                 : axis.limit_minus                  ? AxisError::limit_minus
                                                     : AxisError::limit_plus;
  }
}

void EndingWatch::look_at_list(const Snapshot& now) {
  if (now.feed.running) {
    if (!list_.under_way) begin(list_, Ending::What::list, now.at);
    list_.told.done = now.feed.sent, list_.told.total = now.feed.total;
    return;
  }
  if (!list_.under_way || now.any_axis_moving() || !now.link.connected()) return;
  list_.told.done = now.feed.sent;
  list_.told.by = list_.who != StoppedBy::nobody ? EndedBy::stop : EndedBy::target;
  finish(list_, now.at);
}

void EndingWatch::look_at_pieces(const Snapshot& now) {
  if (now.pieces.running) {
    if (!pieces_.under_way) begin(pieces_, Ending::What::pieces, now.at);
    pieces_.told.done = now.pieces.done, pieces_.told.total = now.pieces.total;
    return;
  }
  if (!pieces_.under_way || now.any_axis_moving() || !now.link.connected()) return;
  pieces_.told.done = now.pieces.done;
  pieces_.told.by = pieces_.who != StoppedBy::nobody         ? EndedBy::stop
                    : pieces_.told.done < pieces_.told.total ? EndedBy::elsewhere
                                                             : EndedBy::target;
  finish(pieces_, now.at);
}

}  // namespace hw
