#pragma once
// How far the axes of a path can go, as far as that is known: the travel that the user has set, and the
// switches of the machine.
#include <array>
#include <optional>

#include "panels/path/path_overlays.h"

namespace hw::panels {

/// Of one direction, in its units.
struct KnownEnds {
  std::optional<double> minus, plus;
};
struct KnownLimits {
  std::array<KnownEnds, 3> travel, switches, home;  ///< by direction
  [[nodiscard]] bool any() const;                   ///< but for home
};
/// Of an emulated machine where the switches are; of a real one, where they have acted.
KnownLimits limits_of(const gui::Frame& frame, const PathSubject& subject);
/// `all`, and around it what is known of the limits.
drawing::Box3 with_limits(drawing::Box3 all, const KnownLimits& limits);
/// As lines; as far as the limits of the other axes, else as far as `all`.
drawing::ToolPath lines_of(const std::array<KnownEnds, 3>& ends, const drawing::Box3& all, bool flat);

void draw_limits(const PathGround& ground, const KnownLimits& limits);
/// Two axes: a cross where both of them are 0.
void draw_zero(const PathGround& ground);

}  // namespace hw::panels
