#pragma once
// The places to which the program of a sequence takes the axes, for intent::RunProgram, so that the user's
// limits apply to it as to a move.
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/sequence/sequence.h"

namespace hw {

/// The least and the greatest place of each axis that it moves, from the present positions; without_end, plus
/// or minus, if a loop takes it on without end. For an axis whose count is doubtful only the places that rely
/// on that count: not distances, nor places after its homing.
std::vector<AxisTarget> places_of_run(const sequence::Sequence& sequence, const Catalog& catalog,
                                      const Snapshot& now);

/// Further than any axis goes: it moves on without end.
inline constexpr Steps without_end{std::int64_t{1} << 61};

}  // namespace hw
