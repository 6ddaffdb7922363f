#pragma once
// A list whose blocks hold text of the controller's own, which may be anything: what the language refuses of
// that is left out as every other block that cannot be written, a comment in its place, and the rest stays a
// program. Pure.
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
/// The fault: nothing can be written. Long, for the worker.
Result<WrittenText> write_without_bad_texts(const Language& language, const sequence::Sequence& sequence,
                                            const Catalog& catalog);

}  // namespace hw::panels
