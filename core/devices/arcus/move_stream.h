#pragma once
// A sequence as moves for the controller's buffer, one piece for each way that the tool draws in one go (PMX
// manual ch. 6): straight lines of X, Y and Z, arcs as chords, the tool switched in between.
#include <optional>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/pieces.h"
#include "core/sequence/sequence.h"

namespace hw::arcus {

/// None: it has steps that the buffer cannot do.
[[nodiscard]] Result<std::optional<Pieces>> stream_moves(const sequence::Sequence& sequence,
                                                         const Catalog& catalog, int from_step);

}  // namespace hw::arcus
