#include "core/device/way_watch.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"

namespace hw {
namespace {

/// Longer than from one step to the next of the slowest motion of a program (1 step/s).
constexpr Duration plain_rest = std::chrono::seconds(2);
constexpr Duration rest_between_programs = Millis(300);
constexpr Duration longest_start = std::chrono::seconds(2), longest_judgement = std::chrono::seconds(3);

bool is_under_way(RunState run) { return run != RunState::idle && run != RunState::error; }

/// A closed loop makes corrections, and its counts are not those of the program.
bool can_be_judged(const AxisState& axis) {
  return axis.position_known && axis.activity != Activity::unknown && !axis.in_counts;
}

bool meets_limit(const AxisState& axis, int direction) {
  return axis.limits_known && (direction < 0 ? axis.limit_minus : axis.limit_plus);
}

/// The driver reports how the motion ended, or the console has begun it.
bool is_of_console(const AxisState& axis) {
  return axis.has_target || axis.activity == Activity::jogging || axis.activity == Activity::homing;
}

bool driver_reports(const AxisState& axis) {
  return axis.activity == Activity::error ||
         (axis.ended_by != EndedBy::nothing && axis.ended_by != EndedBy::target);
}

}  // namespace

void WayWatch::starts(int slot, Instant now) {
  start_ = Start{slot, now};
  for (Axis& axis : axes_) axis.is_ignored = false;
}

void WayWatch::stopped(int axis) {
  axes_[ix(axis)] = Axis();
  axes_[ix(axis)].is_ignored = true;
}

void WayWatch::disturbed() {
  start_.reset(), ways_.reset(), last_cut_.reset();
  over_since_ = {};
  for (Axis& axis : axes_) {
    const bool ignored = axis.is_ignored;
    axis = Axis();
    axis.is_ignored = ignored;
  }
}

WayWatch::Program WayWatch::program(const Snapshot& now, int& slot) const {
  const bool held = now.program.run == RunState::held;  // its motion goes on later
  if (!now.link.connected() || held || now.feed.running || now.pieces.running) return Program::unknown;
  if (catalog_.program.threads == 0) {
    slot = now.program.slot;
    if (now.program.owned && is_under_way(now.program.run)) return Program::runs;
    const bool is_over = now.program.ended_by != EndedBy::nothing || now.program.run == RunState::error;
    return runs_ && !is_over ? Program::runs : Program::over;
  }
  for (int i = 0; i < std::min(catalog_.program.threads, max_threads); ++i) {
    if (!now.threads[ix(i)].known) return Program::unknown;
    if (!is_under_way(now.threads[ix(i)].run)) continue;
    if (slot >= 0 || now.threads[ix(i)].run == RunState::held) return Program::unknown;
    slot = i;
  }
  return slot >= 0 ? Program::runs : Program::over;
}

void WayWatch::follow_program(const Snapshot& now) {
  int slot = -1;
  const Program state = program(now, slot);
  if (std::exchange(restarts_, now.restarts) != now.restarts || state == Program::unknown) disturbed();
  if (start_ && now.at - start_->at > longest_start) disturbed();
  if (state == Program::runs && !std::exchange(runs_, true)) {
    const bool is_ours = start_ && start_->slot == slot;
    if (!is_ours) disturbed();
    ways_ = is_ours && ways_of_ ? ways_of_(slot) : std::nullopt;
    start_.reset(), last_cut_.reset();
    over_since_ = last_rest_ = {};
  }
  if (state != Program::over || !std::exchange(runs_, false) || !ways_) return;
  over_since_ = now.at;
  for (Axis& axis : axes_) axis.still_since = {};
}

std::vector<Ending> WayWatch::look(const Snapshot& now) {
  std::vector<Ending> cut;
  follow_program(now);
  for (int i = 0; i < now.axis_count; ++i) look_at_axis(now, i, cut);
  if (!is_judging() || !is_settled(now)) return cut;
  if (now.any_axis_moving()) last_cut_.reset();  // the last motion of the program goes on
  over_since_ = {};
  ways_.reset();
  return cut;
}

/// Each axis was read twice behind the end of the program, or moves on.
bool WayWatch::is_settled(const Snapshot& now) const {
  if (now.at - over_since_ > longest_judgement) return true;
  bool all_rest = true;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& state = now.axes[ix(i)];
    const Axis& axis = axes_[ix(i)];
    if (!can_be_judged(state)) continue;
    if (state.moves() && state.seen_at > over_since_) return true;
    all_rest = all_rest && axis.still_since != Instant{} && axis.read_at > axis.still_since;
  }
  return all_rest;
}

void WayWatch::look_at_axis(const Snapshot& now, int index, std::vector<Ending>& cut) {
  const AxisState& state = now.axes[ix(index)];
  Axis& axis = axes_[ix(index)];
  if (!can_be_judged(state)) {
    const bool ignored = axis.is_ignored || start_ || ways_;
    axis = Axis();
    axis.is_ignored = ignored;
  } else if (state.moves()) {
    see_motion(state, axis);
  } else if (sees_rest(state, axis, now.at)) {
    judge(now, index, cut);
  }
}

void WayWatch::see_motion(const AxisState& state, Axis& axis) const {
  if (!std::exchange(axis.moved, true)) axis.began = state.seen_at;
  if (!start_ && !ways_) axis.rest.reset();  // not of a program that is judged
  const Steps way = state.commanded() - axis.place;
  if (way != Steps(0) && axis.read_at != Instant{})
    axis.direction = static_cast<std::int8_t>(way > Steps(0) ? 1 : -1);
  axis.place = state.commanded(), axis.read_at = state.seen_at;
  axis.still_since = axis.came_to_rest = {};
  axis.at_limit = false;
  axis.judged_elsewhere = axis.judged_elsewhere || is_of_console(state);
}

/// A place counts as a rest if readings agree for long enough. The last rest before a program is the one
/// before its start was sent.
bool WayWatch::sees_rest(const AxisState& state, Axis& axis, Instant now) const {
  if (axis.came_to_rest == Instant{}) axis.came_to_rest = now;  // its place may be read later
  if (state.seen_at <= axis.read_at || (is_judging() && state.seen_at <= over_since_)) return false;
  const Steps way = state.commanded() - axis.place;
  if (way != Steps(0)) axis.direction = static_cast<std::int8_t>(way > Steps(0) ? 1 : -1);
  if (way != Steps(0) && !axis.moved) axis.came_to_rest = state.seen_at;
  if (way != Steps(0) || axis.still_since == Instant{}) axis.still_since = state.seen_at;
  axis.place = state.commanded(), axis.read_at = state.seen_at;
  axis.at_limit = axis.at_limit || meets_limit(state, axis.direction);
  const Duration rested = axis.read_at - axis.still_since;
  if (start_ || rested <= Duration{}) return false;
  return is_judging() || rested >= (runs_ ? plain_rest : rest_between_programs);
}

void WayWatch::judge(const Snapshot& now, int index, std::vector<Ending>& cut) {
  Axis& axis = axes_[ix(index)];
  const AxisState& state = now.axes[ix(index)];
  const std::optional<Steps> from = std::exchange(axis.rest, axis.place);
  const bool seen = std::exchange(axis.moved, false);
  const bool elsewhere = std::exchange(axis.judged_elsewhere, false);
  if (!ways_ || (!seen && from == axis.place)) return;
  const bool is_judged = seen && from && !axis.is_ignored && !elsewhere && !driver_reports(state);
  const bool was_cut = is_judged && was_cut_short((*ways_)[ix(index)], *from, axis.place);
  Ending ending;
  ending.axis = index;
  ending.began = axis.began;
  ending.at = axis.came_to_rest;
  ending.of_run = ending.place_known = true;
  ending.perhaps_limit = state.ended_by == EndedBy::nothing && !axis.at_limit;
  ending.place = axis.place;
  ending.limit_minus = axis.at_limit && axis.direction < 0;
  ending.limit_plus = axis.at_limit && axis.direction > 0;
  ending.by = axis.at_limit ? EndedBy::limit : EndedBy::elsewhere;
  const bool is_last = axis.came_to_rest > last_rest_ || (axis.came_to_rest == last_rest_ && !was_cut);
  if (is_last) {
    last_rest_ = axis.came_to_rest;
    last_cut_ = was_cut ? std::optional<Ending>(ending) : std::nullopt;
  }
  if (was_cut) cut.push_back(ending);
}

}  // namespace hw
