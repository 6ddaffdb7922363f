#pragma once
// Standalone programs as sequences: what the writer beside it would write, and whatever else says the same.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

[[nodiscard]] Result<SequenceRead> read_sequence(std::string_view text, const sequence::Sequence& frame,
                                                 const Catalog& catalog, const language::Dialect& dialect);

}  // namespace hw::arcus
