#pragma once
// Writes a list whose blocks hold text in the controller's own language, which may be anything. Text that the
// language refuses is left out like any other block that cannot be written: a comment takes its place, and
// the rest stays a program. Pure.
#include <vector>

#include "core/device/language.h"
#include "core/device/refused_steps.h"
#include "core/sequence/sequence.h"

namespace hw::panels {

struct WrittenText {
  SequenceText text;
  ProgramReport report;              ///< of the text
  std::vector<RefusedStep> refused;  ///< in no order
};
/// The fault: nothing can be written. Slow: run it on the worker.
Result<WrittenText> write_without_bad_texts(const Language& language, const sequence::Sequence& sequence,
                                            const Catalog& catalog);

}  // namespace hw::panels
