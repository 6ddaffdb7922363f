#pragma once
// Reads command strings as sequences: the writer's own output, and any other text with the same meaning.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"

namespace hw::vme58 {

[[nodiscard]] Result<SequenceRead> read_sequence(std::string_view text, const sequence::Sequence& frame,
                                                 const Catalog& catalog);

}  // namespace hw::vme58
