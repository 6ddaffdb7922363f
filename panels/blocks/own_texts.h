#pragma once
// Writes a list with blocks that hold any text in the controller's own language. A text that the language
// refuses is left out, as any block that cannot be written: a comment takes its place, and the rest stays a
// program. Pure.
#include <vector>

#include "core/device/language.h"
#include "core/device/refused_steps.h"
#include "core/sequence/sequence.h"

namespace hw::panels {

struct WrittenText {
  SequenceText text;
  ProgramReport report;              ///< of the text
  std::vector<RefusedStep> refused;  ///< not sorted
};
/// Writes the list. A fault means that none of it can be written. Slow: call it on the worker.
Result<WrittenText> write_without_bad_texts(const Language& language, const sequence::Sequence& sequence,
                                            const Catalog& catalog);

}  // namespace hw::panels
