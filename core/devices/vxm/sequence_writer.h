#pragma once
// Sequences as stored programs (VXM manual, Motor Commands, Looping, Pausing). What is repeated inside of
// what is repeated, and what waits for an input that no command waits for, becomes a program of its own, 1
// to 4.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"

namespace hw::vxm {

[[nodiscard]] Result<SequenceText> write_sequence(const sequence::Sequence& sequence, const Catalog& catalog);

}  // namespace hw::vxm
