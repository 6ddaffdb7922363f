#pragma once
// Where the axes stand when a step begins, and how far they come, as far as the steps say. Pure.
#include <array>
#include <cstdint>

#include "core/sequence/editor.h"

namespace hw::sequence {

/// None: nobody knows, since nothing has sent that axis to a place, or each round of a loop begins elsewhere.
Places places_before(const Sequence& sequence, const StepPath& step);

/// The least and the greatest place of each axis, the bulges of arcs and all rounds of loops among them;
/// none: none is known.
struct Reach {
  Places least, greatest;
  /// The sides to which a loop that has no end takes it further in each round.
  std::array<bool, max_axes> endless_minus{}, endless_plus{};
};
/// Of the stretches of the list from each of `bounds`, places in it, to the next. `begin`: where the axes
/// stand before the first step of the list. `until_homed`: of these axes only the places to which they are
/// sent before their home is looked for, which is by the count that they have now.
std::vector<Reach> reaches_between(const Sequence& sequence, const std::vector<std::size_t>& bounds,
                                   const Places& begin = {},
                                   const std::array<bool, max_axes>& until_homed = {});

/// One of the steps moves it, or the tool does that they lift or lower; nobody knows what own text does.
bool is_moved(const Sequence& sequence, int axis);
/// Lifting or lowering the tool moves it.
bool is_moved_by_tool(const Sequence& sequence, int axis);

}  // namespace hw::sequence
