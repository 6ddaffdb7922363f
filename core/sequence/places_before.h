#pragma once
// Where the axes stand when a step begins, and how far they come, as far as the steps say. Pure.
#include "core/sequence/editor.h"

namespace hw::sequence {

/// None: nobody knows, since nothing has sent that axis to a place, or each round of a loop begins elsewhere.
Places places_before(const Sequence& sequence, const StepPath& step);

/// The least and the greatest place of each axis, the bulges of arcs among them; none: none is known.
struct Reach {
  Places least, greatest;
};
/// Of the stretches of the list from each of `bounds`, places in it, to the next.
std::vector<Reach> reaches_between(const Sequence& sequence, const std::vector<std::size_t>& bounds);

}  // namespace hw::sequence
