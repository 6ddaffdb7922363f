#include "core/device/count_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/refusals.h"

namespace hw {
namespace {

/// Whatever else explains it (a restart, a program) shows by then.
constexpr Duration until_believed = std::chrono::seconds(1);
constexpr std::int64_t least_reach = 50;

/// That might set a count by itself.
bool a_program_runs(const Snapshot& now) {
  const auto runs = [](RunState run) { return run == RunState::running || run == RunState::waiting; };
  const bool owned = now.program.owned && runs(now.program.run);
  if (owned || now.working || now.feed.running || now.pieces.running) return true;
  return std::any_of(now.threads.begin(), now.threads.end(),
                     [&](const ThreadState& thread) { return runs(thread.run); });
}

bool nothing_runs(const Snapshot& now) {
  const bool runs = now.program.run == RunState::running || now.program.run == RunState::waiting;
  return !runs && !a_program_runs(now) && !now.any_axis_moving();
}

}  // namespace

// What an encoder counts may be turned by hand.
bool CountWatch::can_tell(const AxisState& axis) const {
  const bool counts = axis.loop == Loop::none || axis.loop == Loop::in_place;
  return axis.position_known && counts && !axis.in_counts && axis.activity == Activity::idle &&
         !axis.trust.doubtful();
}

// Of a motion of somebody else's between two looks.
Steps CountWatch::reach(const AxisState& axis, Duration time) const {
  constexpr double and_more = 1.5;
  const double told = std::max(axis.own_speed.value, axis.speed.value);
  const double speed = told > 0 ? std::max(told, catalog_.jog_speed.value) : catalog_.jog_speed_max.value;
  return Steps(least_reach + std::llround(and_more * speed * seconds(time)));
}

bool CountWatch::was_set(Seen& seen, const AxisState& axis) const {
  const Steps here = axis.commanded();
  if (seen.stood == here) {
    seen.stood_at = axis.seen_at;
    seen.once.reset();
  } else if (seen.once != here) {
    seen.once = here;
    seen.once_at = axis.seen_at;
    seen.took = axis.seen_at - seen.stood_at;
  } else if (axis.seen_at > seen.once_at && (!seen.stood || axis.seen_at - seen.once_at >= until_believed)) {
    const auto before = std::exchange(seen.stood, here);
    seen.stood_at = axis.seen_at;
    seen.once.reset();
    return before && std::abs((here - *before).value) > reach(axis, seen.took).value;
  }
  return false;
}

bool CountWatch::is_own_move(const AxisState& axis) const {
  return axis.position_known && axis.loop == Loop::none && !axis.in_counts && axis.has_target &&
         axis.activity == Activity::moving && !axis.trust.doubtful();
}

// A reading from which no way leads to those that follow is spoilt; those that go on from it for a second
// show another count.
bool CountWatch::leapt(Flight& flight, const AxisState& axis) const {
  const Steps here = axis.commanded();
  const Instant when = axis.seen_at;
  if (!flight.at) flight.at = Flight::Reading{here, when};
  const double to_target = static_cast<double>((axis.target - flight.at->place).value);
  const bool way_is_known = flight.rate * to_target > 0;  // else it may be turning round
  const auto leads_here = [&](const Flight::Reading& from) {
    const auto gone = (here - from.place).value;
    const bool turned = way_is_known && std::abs(gone) > least_reach && (gone > 0) != (to_target > 0);
    return !turned && std::abs(gone) <= reach(axis, when - from.when).value;
  };
  const auto off_its_rate = [&](const Flight::Reading& from) {
    return std::abs(static_cast<double>((here - from.place).value) - flight.rate * seconds(when - from.when));
  };
  const bool goes_on = flight.apart && leads_here(*flight.apart);
  if (leads_here(*flight.at) && !(goes_on && off_its_rate(*flight.apart) < off_its_rate(*flight.at))) {
    if (when > flight.at->when)
      flight.rate = static_cast<double>((here - flight.at->place).value) / seconds(when - flight.at->when);
    flight.at = Flight::Reading{here, when};
    flight.apart.reset();
    return false;
  }
  if (!goes_on) flight.apart = Flight::Reading{here, when};
  return when - flight.apart->when >= until_believed;
}

std::uint32_t CountWatch::look_at_moves(const Snapshot& now) {
  std::uint32_t set = 0;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    if (!is_own_move(axis))
      flights_[ix(i)] = {};
    else if (leapt(flights_[ix(i)], axis))
      set |= 1u << i;
  }
  return set;
}

std::uint32_t CountWatch::look(const Snapshot& now) {
  const World world{now.restarts, now.link.timeouts};
  if (std::exchange(world_, world) != world || a_program_runs(now)) {
    disturbed();
    return 0;
  }
  if (!nothing_runs(now)) {
    seen_ = {};
    return look_at_moves(now);
  }
  flights_ = {};
  std::uint32_t set = 0;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    if (!can_tell(axis))
      seen_[ix(i)] = {};
    else if (was_set(seen_[ix(i)], axis))
      set |= 1u << i;
  }
  return set;
}

std::string say_count_was_set(const Catalog& catalog, int axis) {
  return fmt::format(
      "The count of {} was changed by another program or at the controller, and no motion explains that. "
      "Home it, or say where it stands, before the next absolute move.",
      spoken_name(catalog, axis));
}

}  // namespace hw
