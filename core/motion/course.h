#pragma once
// A motion of one or more axes of an emulated controller along a track by a profile, from mark to mark. A
// mark is a step at which something must be checked: a switch, an index, a lost load, a turn of the track.
// Between marks nothing is computed. For controllers that move axes together; step_axis.h is one axis by
// itself.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

#include "core/base/index.h"
#include "core/motion/profile.h"

namespace hw::motion {

/// `Track` is a Path, or has the same functions.
template <class Track>
struct Course {
  bool active = false;
  bool stopping = false;  ///< on its last ramp
  unsigned axes = 0;      ///< a bit for each
  Track track;
  Profile profile;
  std::int64_t applied = 0;    ///< steps made
  std::int64_t next_mark = 0;  ///< step of the next check

  [[nodiscard]] bool has(int axis) const { return (axes >> axis & 1u) != 0; }
  [[nodiscard]] bool alone() const { return (axes & (axes - 1)) == 0; }

  /// When its next mark is reached, or its end; none: it does not run.
  [[nodiscard]] std::optional<Instant> due() const {
    if (!active) return std::nullopt;
    return next_mark <= profile.length() ? profile.time_at(next_mark) : profile.end();
  }
  /// The step that is reached by now, at most that of the mark.
  [[nodiscard]] std::int64_t reached(Instant now) const { return std::min(profile.steps(now), next_mark); }
  [[nodiscard]] bool has_arrived(Instant now) const {
    return profile.end() <= now && applied >= profile.length();
  }
  /// Where it ends if nothing more happens.
  [[nodiscard]] std::int64_t last_step() const { return std::min(profile.length(), track.steps()); }

  /// Makes the steps up to `step`: calls turn(axis, direction, count) for each axis that they move.
  template <class Turn>
  void make_steps(std::int64_t step, const Turn& turn) {
    if (step <= applied) return;
    for (int axis = 0; axes >> axis != 0; ++axis) {
      if (!has(axis)) continue;
      const std::int64_t made = track.offset(ix(axis), step) - track.offset(ix(axis), applied);
      if (made != 0) turn(axis, made < 0 ? -1 : 1, std::abs(made));
    }
    applied = step;
  }

  /// Marks only the next turn of the track.
  void mark_turn() {
    const std::int64_t turn = track.next_turn(applied);
    next_mark = turn < track.steps() ? turn : std::numeric_limits<std::int64_t>::max();
  }
  /// Marks the step at which the axis has made `turns` more steps in direction `way`, if it lies ahead.
  void mark(int axis, int way, std::optional<std::int64_t> turns) {
    if (!turns || *turns <= 0) return;
    const std::int64_t here = track.offset(ix(axis), applied);
    if (const auto step = track.first_at(ix(axis), applied, here + way * *turns))
      next_mark = std::min(next_mark, *step);
  }

  /// The ramp down from here; where the track is too short for it, a steeper one that ends with the track.
  [[nodiscard]] Profile ramp_within_track(Instant now, const Ramp& ramp) const {
    const double from = profile.distance(now);
    const Pps speed = profile.speed(now);
    const Profile down = Profile::ramp_down(now, from, speed, ramp);
    if (down.length() <= track.steps()) return down;
    return Profile::approach(now, from, speed, speed, ramp.decel, ramp, track.steps());
  }
};

}  // namespace hw::motion
