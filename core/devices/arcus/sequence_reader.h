#pragma once
// Reads standalone programs as sequences: texts of sequence_writer, and others with the same meaning.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

[[nodiscard]] Result<SequenceRead> read_sequence(std::string_view text, const sequence::Sequence& frame,
                                                 const Catalog& catalog, const language::Dialect& dialect);

}  // namespace hw::arcus
