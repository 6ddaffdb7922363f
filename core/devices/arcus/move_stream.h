#pragma once
// A sequence as moves for the controller's buffer, one piece for each stretch that the tool draws without a
// break (PMX manual ch. 6): straight lines of X, Y and Z, arcs as chords, the tool switched in between.
#include <optional>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/pieces.h"
#include "core/sequence/sequence.h"

namespace hw::arcus {

/// None: the buffer cannot do some of the steps.
[[nodiscard]] Result<std::optional<Pieces>> stream_moves(const sequence::Sequence& sequence,
                                                         const Catalog& catalog, int from_step);

}  // namespace hw::arcus
