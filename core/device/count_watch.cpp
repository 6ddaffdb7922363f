#include "core/device/count_watch.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/refusals.h"

namespace hw {
namespace {

constexpr double most_counts_per_pulse = 10;

/// A program may set a count.
bool a_program_runs(const Snapshot& now) {
  const auto runs = [](RunState run) { return run == RunState::running || run == RunState::waiting; };
  const bool owned = now.program.owned && runs(now.program.run);
  if (owned || now.working || now.feed.running || now.pieces.running) return true;
  return std::any_of(now.threads.begin(), now.threads.end(),
                     [&](const ThreadState& thread) { return runs(thread.run); });
}

/// A free motor may be turned by hand, and the encoder counts.
bool is_free(const AxisState& axis) {
  return axis.loop == Loop::open || axis.loop == Loop::unknown || (axis.in_counts && !axis.enabled);
}

bool can_judge(const AxisState& axis) {
  const bool seen = axis.activity != Activity::unknown && axis.activity != Activity::homing;
  return axis.position_known && seen && !is_free(axis) && !axis.trust.doubtful();
}

}  // namespace

/// The speed of a motion that the console has not begun is unknown: it may be the highest of the controller.
/// Speeds are in pulses; an encoder may make several counts for each pulse.
CountReading CountWatch::reading_of(const AxisState& axis) const {
  CountReading reading;
  reading.place = axis.commanded();
  reading.when = axis.seen_at;
  reading.any_speed = std::max(catalog_.jog_speed_max.value, catalog_.jog_speed.value);
  reading.range = static_cast<double>((catalog_.position_max - catalog_.position_min).value);
  const bool goes = axis.activity == Activity::moving && axis.has_target;
  const bool jogs = axis.activity == Activity::jogging && axis.speed.value > 0;
  const double known_speed = std::max(axis.own_speed.value, axis.speed.value);
  const bool is_known = known_speed > 0 && (goes || jogs || axis.activity == Activity::idle);
  reading.fastest = is_known ? std::max(known_speed, catalog_.jog_speed.value) : reading.any_speed;
  if (axis.in_counts) reading.fastest = std::min(reading.any_speed, reading.fastest * most_counts_per_pulse);
  if (goes && axis.target != reading.place) reading.way = axis.target > reading.place ? 1 : -1;
  return reading;
}

/// The controller may set the count until the axis stands.
void CountWatch::look_for_homing(const Snapshot& now) {
  for (int i = 0; i < now.axis_count; ++i) {
    const Activity does = now.axes[ix(i)].activity;
    if (does == Activity::homing) homing_ |= 1u << i;
    if (does == Activity::idle || does == Activity::error) homing_ &= ~(1u << i);
  }
}

std::uint32_t CountWatch::look(const Snapshot& now) {
  look_for_homing(now);
  const Epoch epoch{now.restarts, now.link.timeouts};
  if (std::exchange(epoch_, epoch) != epoch || a_program_runs(now)) {
    disturbed();
    return 0;
  }
  std::uint32_t set = 0;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    Track& track = tracks_[ix(i)];
    const bool homes = (homing_ >> i & 1u) != 0;
    if (homes || !can_judge(axis) || std::exchange(track.in_counts, axis.in_counts) != axis.in_counts)
      track.readings.forget();
    else if (track.readings.add(reading_of(axis)))
      set |= 1u << i;
  }
  return set;
}

std::string describe_count_was_set(const Catalog& catalog, int axis) {
  return fmt::format(
      "Home {}, or set its position, before the next absolute move: its count was changed by another program "
      "or at the controller, without a motion.",
      spoken_name(catalog, axis));
}

}  // namespace hw
