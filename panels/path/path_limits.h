#pragma once
// Finds and draws the known range of the axes of a path: the travel set by the user, and the switches of the
// machine.
#include <array>
#include <optional>

#include "panels/path/path_overlays.h"

namespace hw::panels {

/// The ends in one direction, in its units.
struct KnownEnds {
  std::optional<double> minus, plus;
};
struct KnownLimits {
  std::array<KnownEnds, 3> travel, switches, home;  ///< by direction
  [[nodiscard]] bool any() const;                   ///< except home
};
/// The known limits. The switches of an emulated machine are known; those of a real machine only where they
/// have operated.
KnownLimits limits_of(const gui::Frame& frame, const PathSubject& subject);
/// `all`, extended by the known limits.
drawing::Box3 with_limits(drawing::Box3 all, const KnownLimits& limits);
/// Turns limits into lines, as long as the limits of the other axes, or as `all` where these are unknown.
drawing::ToolPath lines_of(const std::array<KnownEnds, 3>& ends, const drawing::Box3& all, bool flat);

void draw_limits(const PathGround& ground, const KnownLimits& limits);
/// For two axes: draws a cross at 0, 0.
void draw_zero(const PathGround& ground);

}  // namespace hw::panels
