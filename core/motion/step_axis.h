#pragma once
// A plain step axis of an emulated controller: one motion at a time, in closed form. It ends at its target,
// at a travel limit switch, at the home switch or by a stop. Nothing ticks: its owner asks when something is
// next due. The listed controllers keep their own: Arcus and VME58 move axes together (course.h), and a VXM
// counts pulses and detects its limits on the way.
#include <cstdint>
#include <optional>

#include "core/motion/plant.h"
#include "core/motion/profile.h"

namespace hw::motion {

class StepAxis {
 public:
  enum class State : std::uint8_t { rests, moves, slows };
  enum class Ended : std::uint8_t { nothing, target, limit, home, stop, kill };
  enum class Seeks : std::uint8_t { target, limit_switch, home_switch };

  Plant plant;
  Steps position{};  ///< its counter

  /// Begins a motion. One that seeks a switch ends at once where that acts, and the counter is 0 there. Not
  /// while it moves.
  void begin(Instant now, Sign sign, const Profile& profile, Seeks seeks = Seeks::target);
  /// Ramps down. Nothing at rest, or while it slows down already.
  void slow(Instant now, double decel);
  void kill();
  /// A switch, a jam or the place of the load has changed.
  void plant_changed() { plan(); }

  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> next_event() const;

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] Ended ended() const { return ended_; }
  [[nodiscard]] Pps speed(Instant now) const { return state_ == State::rests ? Pps() : profile_.speed(now); }

 private:
  void plan();
  void finish(Ended how);

  Profile profile_;
  Sign sign_ = Sign::plus;
  State state_ = State::rests;
  Ended ended_ = Ended::nothing;
  Seeks seeks_ = Seeks::target;
  std::int64_t made_ = 0;     ///< steps of the profile
  std::int64_t last_ = 0;     ///< the step at which the motion ends ...
  Ended by_ = Ended::target;  ///< ... and by what
};

/// The earliest event of several axes; none: all rest.
template <class Axes>
std::optional<Instant> next_event_of(const Axes& axes) {
  std::optional<Instant> next;
  for (const StepAxis& axis : axes)
    if (const auto due = axis.next_event(); due && (!next || *due < *next)) next = due;
  return next;
}

}  // namespace hw::motion
