#pragma once
// The places that the program of a sequence reaches, for intent::RunProgram, so that the user's limits apply
// to it as to a move.
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/sequence/sequence.h"

namespace hw {

/// The least and the greatest place of each axis that the sequence moves, from the present positions; plus or
/// minus without_end if a loop moves the axis on without end. For an axis whose count is doubtful only the
/// places that rely on that count: neither distances nor places after its homing.
std::vector<AxisTarget> places_of_run(const sequence::Sequence& sequence, const Catalog& catalog,
                                      const Snapshot& now);

/// Stands for a motion without end: further than any axis goes.
inline constexpr Steps without_end{std::int64_t{1} << 61};

}  // namespace hw
