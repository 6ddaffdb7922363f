#pragma once
// A profile is a closed form of distance over time: consecutive stretches, each with the speed curve of its
// ramp. Distance counts steps travelled, whatever the direction; step `k` occurs at one exact time.
//
//   speed     slew
//     |    ________
//     |   /        \      index(): ramp up, slew, ramp down; a triangle when the way is too short
//     |  /          \     change(): from one speed to another, then on to the end at that speed
//     | /            \    stop():   from one speed to rest on a whole step
//     |                   approach(): to another speed, on, and down to the start speed at the end
//     |                   ramp_down(): to the start speed, and there it ends
//     +------------------ time
//
// Ramps between two speeds, over the same distance and in the same time, but for the last:
//   linear       constant acceleration
//   s_curve      acceleration up to twice the mean, and down again, linearly
//   half_cosine  half a cosine of speed: the acceleration is half a sine, pi/2 of the mean at its peak
//   parabolic    acceleration falls linearly with speed: full at the start speed, less by `truncation` at
//   `top`
#include <array>
#include <cstdint>
#include <optional>

#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw::motion {

enum class RampShape : std::uint8_t { linear, s_curve, half_cosine, parabolic };
enum class Phase : std::uint8_t { ended, accelerating, constant, decelerating };

struct Ramp {
  double accel = 1, decel = 1;  ///< steps/s², the mean of an S-curve
  Pps start_speed;              ///< speed that needs no ramp
  RampShape shape = RampShape::linear;
  double truncation = 0;  ///< parabolic: share of the acceleration lost at `top`, 0 to below 1
  Pps top;                ///< parabolic: speed of that; the profile's highest speed if higher
  Ramp(double up, double down, Pps start = Pps(0), RampShape form = RampShape::linear)
      : accel(up), decel(down), start_speed(start), shape(form) {}
};

class Profile {
 public:
  /// Ends at once, at distance 0.
  Profile() = default;
  /// From rest over `length` steps to rest.
  static Profile index(Instant start, std::int64_t length, Pps slew, const Ramp& ramp);
  /// At `start` the distance is `from` and the speed `now`; changes to `wanted` and keeps it up to `end`.
  static Profile change(Instant start, double from, Pps now, Pps wanted, const Ramp& ramp, std::int64_t end);
  /// Slows to rest on the whole step nearest to the natural stopping point.
  static Profile stop(Instant start, double from, Pps now, double decel);
  /// Slows to rest after exactly `length` more steps, at the constant rate needed.
  static Profile stop_within(Instant start, double from, Pps now, std::int64_t length);

  [[nodiscard]] Instant start() const { return start_; }
  [[nodiscard]] Instant end() const { return end_; }
  /// Total steps at the end.
  [[nodiscard]] std::int64_t length() const { return length_; }
  [[nodiscard]] double distance(Instant t) const;
  [[nodiscard]] Pps speed(Instant t) const;
  [[nodiscard]] Pps final_speed() const;
  /// Whole steps made up to and including `t`.
  [[nodiscard]] std::int64_t steps(Instant t) const;
  /// Time of step `k`: the start for steps before it, the end for steps beyond it.
  [[nodiscard]] Instant time_at(std::int64_t k) const;
  /// Begin of the last slowing down; none: it does not end at rest.
  [[nodiscard]] std::optional<Instant> slows_at() const;

  /// At `start` the distance is `from` and the speed `now`; changes to `wanted` at `ramp.accel` or, if that
  /// is slower, `change_down`, keeps it, and slows to `ramp.start_speed` at `end`. If the distance is too
  /// short, the peak is lower or the deceleration as steep as needed.
  static Profile approach(Instant start, double from, Pps now, Pps wanted, double change_down,
                          const Ramp& ramp, std::int64_t end);
  /// Slows to `ramp.start_speed`, then rests at once, on the nearest whole step.
  static Profile ramp_down(Instant start, double from, Pps now, const Ramp& ramp);
  /// `length` steps at one speed from the first to the last.
  static Profile constant(Instant start, double from, Pps speed, std::int64_t end);

  [[nodiscard]] Phase phase(Instant t) const;

  /// A distance that no motion reaches: for moves without an end.
  static constexpr std::int64_t endless = std::int64_t{1} << 50;

 private:
  struct Stretch {
    double begin_s, lasts_s, from, to, v0, v1;
    RampShape shape;
    double a0, bend;  ///< s_curve: acceleration at its beginning, jerk; parabolic: at its slow end, 1/s
    [[nodiscard]] double distance(double u) const;
    [[nodiscard]] double speed(double u) const;
    [[nodiscard]] double time_at(double d) const;
  };
  struct Law;
  void hold(double to);
  void ramp(double to, double v1, const Law& law);
  void ramp(double to, double v1);
  void add_stretch(double lasts_s, double to, double v1, RampShape shape, double a0, double bend);
  void finish(std::int64_t length);
  [[nodiscard]] double since_start(Instant t) const { return seconds(t - start_); }
  [[nodiscard]] const Stretch* at(double t) const;

  Instant start_{}, end_{};
  std::int64_t length_ = 0;
  double from_ = 0, v_ = 0, distance_ = 0, time_ = 0;  ///< begin of the profile; begin of the next stretch
  std::array<Stretch, 5> stretches_{};
  int count_ = 0;
};

}  // namespace hw::motion
