#pragma once
// Writes sequences as command strings in AA mode, where motions follow one another. Contours and arcs are
// recorded and played (data sheet, "Constant Velocity Contouring").
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/refused_steps.h"
#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"

namespace hw::vme58 {

/// `refused`: collects the steps that PartialWriter reports; null: the first refused step ends the writing.
[[nodiscard]] Result<SequenceText> write_sequence(const sequence::Sequence& sequence, const Catalog& catalog,
                                                  std::vector<RefusedStep>* refused = nullptr);

}  // namespace hw::vme58
