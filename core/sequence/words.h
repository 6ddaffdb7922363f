#pragma once
// Titles and summaries of steps, for people.
#include <array>
#include <string>
#include <string_view>

#include "core/base/fixed_text.h"
#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Display of a number: `factor` times its value in the sequence's own unit.
struct Scale {
  std::string unit;
  double factor = 1;
  int decimals = 6;
  bool operator==(const Scale&) const = default;
  [[nodiscard]] double shown(double value) const;
  [[nodiscard]] double kept(double shown) const;
};
/// Display of a whole sequence.
struct Look {
  std::array<Scale, max_axes> axes;  ///< by index in Sequence::axes
  Scale all;                         ///< for numbers that belong to no particular axis
  bool operator==(const Look&) const = default;
  [[nodiscard]] const Scale& of_axis(int axis) const;
  /// For the speed of a motion: the axes' scale if it is the same for all.
  [[nodiscard]] const Scale& of_motion(const Step::Body& body) const;
  /// Whether one of its two axes is shown reversed.
  [[nodiscard]] bool mirrors(const Plane& plane) const;
};
/// The sequence in its own unit.
Look own_look(const Sequence& of);
/// Whether the arc is shown clockwise; a reversed axis swaps the direction.
bool clockwise(const Arc& arc, const Look& look);

/// "Move to", "Circle".
std::string_view title_of(const Step::Body& body);
/// "X 40, Y 25", "until input 2 is on".
std::string summary_of(const Step::Body& body, const Sequence& of);
std::string summary_of(const Step::Body& body, const Sequence& of, const Look& look);
/// Label of a step's field from its key in files, with the unit shown: "ramp_ms" is "Ramp, ms".
FixedText<64> label_of_field(std::string_view key, std::string_view unit);

}  // namespace hw::sequence
