#pragma once
// Sequences as command strings of the AA mode, where one motion follows the other. Contours and arcs are
// recorded and played (data sheet, "Constant Velocity Contouring").
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"

namespace hw::vme58 {

[[nodiscard]] Result<SequenceText> write_sequence(const sequence::Sequence& sequence, const Catalog& catalog);

}  // namespace hw::vme58
