#pragma once
// Where the axes stand when a step begins, as far as the steps before it say. Pure.
#include "core/sequence/editor.h"

namespace hw::sequence {

/// None: nobody knows, since nothing has sent that axis to a place, or each round of a loop begins elsewhere.
Places places_before(const Sequence& sequence, const StepPath& step);

}  // namespace hw::sequence
