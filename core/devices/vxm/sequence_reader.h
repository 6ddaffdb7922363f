#pragma once
// Stored programs as sequences: what the writer beside it would write, and whatever else says the same.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"

namespace hw::vxm {

[[nodiscard]] Result<SequenceRead> read_sequence(std::string_view text, const sequence::Sequence& frame,
                                                 const Catalog& catalog);

}  // namespace hw::vxm
