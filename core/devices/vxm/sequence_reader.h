#pragma once
// Reads stored programs as sequences: those of the sequence writer, and any of the same meaning.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"

namespace hw::vxm {

[[nodiscard]] Result<SequenceRead> read_sequence(std::string_view text, const sequence::Sequence& frame,
                                                 const Catalog& catalog);

}  // namespace hw::vxm
