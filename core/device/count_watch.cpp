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

bool nothing_runs(const Snapshot& now) {
  const auto runs = [](RunState run) { return run == RunState::running || run == RunState::waiting; };
  if (runs(now.program.run) || now.working || now.feed.running || now.pieces.running) return false;
  for (const ThreadState& thread : now.threads)
    if (runs(thread.run)) return false;
  return !now.any_axis_moving();
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
  constexpr std::int64_t at_least = 50;
  const double told = axis.own_speed.value;
  const double speed = told > 0 ? std::max(told, catalog_.jog_speed.value) : catalog_.jog_speed_max.value;
  return Steps(at_least + std::llround(and_more * speed * seconds(time)));
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

std::uint32_t CountWatch::look(const Snapshot& now) {
  const World world{now.restarts, now.link.timeouts};
  if (std::exchange(world_, world) != world || !nothing_runs(now)) {
    disturbed();
    return 0;
  }
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
      "The count of {} was changed by another program or at the controller, without a motion. Find home, or "
      "say where it stands, before the next absolute move.",
      spoken_name(catalog, axis));
}

}  // namespace hw
