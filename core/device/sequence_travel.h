#pragma once
// Where the program that is made of a sequence takes the axes of its controller: what intent::RunProgram is
// told, so that it is bound by the user's travel as a move is.
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/sequence/sequence.h"

namespace hw {

/// The least and the greatest place of each axis that it moves, from where they stand now; without_end, plus
/// or minus, where a loop takes it on and on. Of an axis whose count is not to be trusted only where it is
/// sent by that count: by no distance, nor once its home is looked for.
std::vector<AxisTarget> places_of_run(const sequence::Sequence& sequence, const Catalog& catalog,
                                      const Snapshot& now);

/// So far no axis goes: it goes on and on.
inline constexpr Steps without_end{std::int64_t{1} << 61};

}  // namespace hw
