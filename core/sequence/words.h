#pragma once
// What a step is called and says, for people.
#include <array>
#include <string>
#include <string_view>

#include "core/base/fixed_text.h"
#include "core/sequence/sequence.h"

namespace hw::sequence {

/// What a number of a sequence is shown as: `factor` times what it is in the sequence's own unit.
struct Scale {
  std::string unit;
  double factor = 1;
  int decimals = 6;
  bool operator==(const Scale&) const = default;
  [[nodiscard]] double shown(double value) const;
  [[nodiscard]] double kept(double shown) const;
};
/// How all of a sequence is shown.
struct Look {
  std::array<Scale, max_axes> axes;  ///< by place in Sequence::axes
  Scale all;                         ///< of what is of no axis in particular
  bool operator==(const Look&) const = default;
  [[nodiscard]] const Scale& of_axis(int axis) const;
  /// Of a speed of axes: theirs, where it is the same for each.
  [[nodiscard]] const Scale& of_motion(const Step::Body& body) const;
  /// One of its two axes is shown the other way round.
  [[nodiscard]] bool mirrors(const Plane& plane) const;
};
/// In its own unit.
Look own_look(const Sequence& of);
/// As it is shown: of an axis that is shown the other way round it is the other.
bool clockwise(const Arc& arc, const Look& look);

/// "Move to", "Circle".
std::string_view title_of(const Step::Body& body);
/// "X 40, Y 25", "until input 2 is on".
std::string summary_of(const Step::Body& body, const Sequence& of);
std::string summary_of(const Step::Body& body, const Sequence& of, const Look& look);
/// A field of a step, from its key in files, with what its numbers are shown in: "ramp_ms" is "Ramp, ms".
FixedText<64> label_of_field(std::string_view key, std::string_view unit);

}  // namespace hw::sequence
