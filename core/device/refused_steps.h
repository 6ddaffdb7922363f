#pragma once
// A sequence as text even where some of its steps cannot be written: whoever edits it sees all of those at
// once, and the rest as it is. A Language is such a writer, too.
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/sequence_text.h"

namespace hw {

struct RefusedStep {
  int step = -1;                    ///< as SequenceText counts them
  std::string field;                ///< what of it: its key in files, of a move "to/X"; empty: all of it
  std::string what;                 ///< "Step 3.2 (arc): a VXM draws no arcs."
  std::string why;                  ///< the same without the step
  std::optional<double> nearest{};  ///< what the field could be, in the unit of the sequence
};

class PartialWriter {
 public:
  virtual ~PartialWriter() = default;
  /// As Language::write, with a comment in the place of each step that is refused. The fault: nothing can be
  /// written. Not for running.
  [[nodiscard]] virtual Result<SequenceText> write_what_can_be(const sequence::Sequence& sequence,
                                                               const Catalog& catalog,
                                                               std::vector<RefusedStep>& refused) const = 0;
};

}  // namespace hw
