#pragma once
// Blocks as the text that a controller's language makes of them: of those that it refuses the reason, and of
// the others the text. Pure.
#include <cstdint>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/device/refused_steps.h"
#include "core/sequence/sequence.h"

namespace hw::panels {

/// Of one version of the blocks.
struct WrittenBlocks {
  std::uint64_t version = ~std::uint64_t{0};
  SequenceText text;                     ///< of those that can be written
  std::vector<std::size_t> line_begins;  ///< of the text, and its end
  std::vector<int> step_of_command;      ///< of its first program
  std::vector<int> lines_of_step;        ///< how many each block has itself
  std::string problem;                   ///< why it is not to be run; empty: it is
  std::vector<RefusedStep> refused{};    ///< in the order of the blocks, one for each; `why` is a sentence
  std::string remark;
  int cost = 0;  ///< of the text, in the unit of ProgramFacts::capacity

  /// Null: the block is written.
  [[nodiscard]] const RefusedStep* refusal_of(int row) const;
  /// How many before `row`.
  [[nodiscard]] int refused_before(int row) const;
};

/// Long, for the worker.
WrittenBlocks write_blocks(const Language& language, const sequence::Sequence& sequence,
                           const Catalog& catalog);

}  // namespace hw::panels
