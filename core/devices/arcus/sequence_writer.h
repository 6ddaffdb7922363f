#pragma once
// Writes sequences as standalone programs (PMX manual ch. 10, DMX manual ch. 10). The tool's routines become
// SUB 1 and SUB 2, as in the maker's own converter; loops count in V49 downwards.
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/refused_steps.h"
#include "core/device/sequence_text.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/sequence/sequence.h"

namespace hw::arcus {

inline constexpr int pen_up_sub = 1, pen_down_sub = 2;
inline constexpr int first_counter = 49;  ///< those from V50 on are kept in flash

/// `refused`: collects the refused steps (see PartialWriter); null: the first refused step is a fault.
[[nodiscard]] Result<SequenceText> write_sequence(const sequence::Sequence& sequence, const Catalog& catalog,
                                                  const language::Dialect& dialect,
                                                  std::vector<RefusedStep>* refused = nullptr);

}  // namespace hw::arcus
