#pragma once
// Sequences as command strings of the AA mode, where one motion follows the other. Contours and arcs are
// recorded and played (data sheet, "Constant Velocity Contouring").
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/refused_steps.h"
#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"

namespace hw::vme58 {

/// `refused`: collects what PartialWriter tells of; null: the first step that is refused is the end.
[[nodiscard]] Result<SequenceText> write_sequence(const sequence::Sequence& sequence, const Catalog& catalog,
                                                  std::vector<RefusedStep>* refused = nullptr);

}  // namespace hw::vme58
