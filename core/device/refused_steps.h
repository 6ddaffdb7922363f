#pragma once
// Writes a sequence as text although some of its steps are refused, so that an editor shows all refusals at
// once, and the rest. A Language can do this too.
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"

namespace hw {

struct RefusedStep {
  int step = -1;      ///< as SequenceText counts them
  std::string field;  ///< the refused field by its key in files, of a move "to/X"; empty: the whole step
  std::string what;   ///< "Step 3.2 (arc): a VXM draws no arcs."
  std::string why;    ///< the reason alone, as a sentence
  std::optional<double> nearest{};  ///< the nearest possible value, in the unit of the sequence
};

class PartialWriter {
 public:
  virtual ~PartialWriter() = default;
  /// As Language::write, with a comment in place of each refused step. A fault: nothing can be written. The
  /// text must not be run.
  [[nodiscard]] virtual Result<SequenceText> write_with_gaps(const sequence::Sequence& sequence,
                                                             const Catalog& catalog,
                                                             std::vector<RefusedStep>& refused) const = 0;
};

}  // namespace hw
