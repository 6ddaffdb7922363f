#pragma once
// A path of several axes, divided into steps of at most one pulse: a line by the rule of the leading axis, or
// an arc. Offsets count from the start of the path. A Profile gives the time of each step.
//
//   line:  the leading axis makes a pulse at each step, the others theirs as evenly as whole pulses can be
//   arc:   steps of equal angle; each axis stands on the pulse nearest to the true circle
//
// Between two turns() every axis keeps its direction.
#include <array>
#include <cstdint>
#include <optional>

#include "core/base/units.h"

namespace hw::motion {

inline constexpr std::size_t path_axes = max_axes;
using Offsets = std::array<std::int64_t, path_axes>;

class Path {
 public:
  Path() = default;
  static Path along(std::size_t axis, Sign way, std::int64_t length);
  static Path line(const Offsets& to);
  /// Around a centre at (-from_x, -from_y) from the start, by `sweep` radians; positive: counter-clockwise
  /// with x to the right and y up.
  static Path arc(std::size_t x_axis, std::size_t y_axis, double from_x, double from_y, double sweep);

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  /// Distance of the tool per step, in pulses.
  [[nodiscard]] double pulses_per_step() const { return pulses_per_step_; }
  [[nodiscard]] std::int64_t offset(std::size_t axis, std::int64_t step) const;
  /// Position of the axis in fractions of pulses.
  [[nodiscard]] double exact(std::size_t axis, double step) const;
  [[nodiscard]] bool moves(std::size_t axis) const;
  /// Direction of `axis` between `step` and the next turn: -1, 0, 1.
  [[nodiscard]] int direction(std::size_t axis, std::int64_t step) const;
  /// The first step after `step` where an axis may reverse; the last step if none does.
  [[nodiscard]] std::int64_t next_turn(std::int64_t step) const;
  /// The first step after `step`, before the next turn, at which `axis` is at or beyond `offset`.
  [[nodiscard]] std::optional<std::int64_t> first_at(std::size_t axis, std::int64_t step,
                                                     std::int64_t offset) const;
  /// The axis' share of the tool's speed at a step: -1 to 1.
  [[nodiscard]] double share(std::size_t axis, double step) const;

 private:
  [[nodiscard]] double angle(double step) const;

  Offsets to_{};
  std::int64_t steps_ = 0;
  double pulses_per_step_ = 1;
  bool arc_ = false;
  std::size_t x_ = 0, y_ = 1;
  double radius_ = 0, begin_ = 0, sweep_ = 0, from_x_ = 0, from_y_ = 0;
};

}  // namespace hw::motion
