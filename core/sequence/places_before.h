#pragma once
// Positions of the axes when a step begins, and their reach, as far as the steps determine them. Pure.
#include <array>
#include <cstdint>

#include "core/sequence/editor.h"

namespace hw::sequence {

/// None: unknown, as no step has sent the axis to a place, or each pass of a loop begins elsewhere.
Places places_before(const Sequence& sequence, const StepPath& step);

/// The lowest and highest position of each axis, with the bulges of arcs and all passes of loops; none:
/// unknown.
struct Reach {
  Places least, greatest;
  /// Directions in which an endless loop goes further with each pass.
  std::array<bool, max_axes> endless_minus{}, endless_plus{};
};
/// One Reach for each stretch of the list between neighbouring `bounds` (indexes). `begin`: positions before
/// the first step. `until_homed`: for these axes only places before their first unconditional homing count,
/// as only these refer to the present count.
std::vector<Reach> reaches_between(const Sequence& sequence, const std::vector<std::size_t>& bounds,
                                   const Places& begin = {},
                                   const std::array<bool, max_axes>& until_homed = {});

/// Whether a step, or a tool routine that a step uses, moves the axis. Custom text is not examined.
bool is_moved(const Sequence& sequence, int axis);
/// Whether lifting or lowering the tool moves the axis.
bool is_moved_by_tool(const Sequence& sequence, int axis);

}  // namespace hw::sequence
