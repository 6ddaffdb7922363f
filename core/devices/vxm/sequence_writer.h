#pragma once
// Writes sequences as stored programs (VXM manual, Motor Commands, Looping, Pausing). A nested loop, and a
// wait for an input that no command waits for, becomes a program of its own, 1 to 4.
#include <array>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/refused_steps.h"
#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"

namespace hw::vxm {

/// U commands that switch the outputs (App. B).
inline constexpr std::array<int, 4> output_on{5, 15, 17, 19}, output_off{4, 14, 16, 18};

/// `refused`: collects the refused steps, see PartialWriter; null: the first one ends the writing.
[[nodiscard]] Result<SequenceText> write_sequence(const sequence::Sequence& sequence, const Catalog& catalog,
                                                  std::vector<RefusedStep>* refused = nullptr);

}  // namespace hw::vxm
