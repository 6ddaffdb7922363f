#pragma once
// Writes blocks in a controller's language: gives the reason for each refused block, and the text of the
// others. Pure.
#include <cstdint>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/device/refused_steps.h"
#include "core/sequence/sequence.h"

namespace hw::panels {

/// The result for a version of the blocks.
struct WrittenBlocks {
  std::uint64_t version = ~std::uint64_t{0};
  SequenceText text;                     ///< text of the blocks that can be written
  std::vector<std::size_t> line_begins;  ///< begin of each line of the text, and its end
  std::vector<int> step_of_command;      ///< step of each command of the first program
  std::vector<int> lines_of_step;        ///< number of lines of each block itself
  std::string problem;                   ///< why the text must not be run; empty: it may
  std::vector<RefusedStep> refused{};    ///< in the order of the blocks, one for each; `why` is a sentence
  std::string remark;
  int cost = 0;  ///< memory of the text, in the unit of ProgramFacts::capacity

  /// Why a block was refused; null: it was written.
  [[nodiscard]] const RefusedStep* refusal_of(int row) const;
  /// Number of refused blocks before `row`.
  [[nodiscard]] int refused_before(int row) const;
};

/// Writes the blocks. Slow: call it on the worker.
WrittenBlocks write_blocks(const Language& language, const sequence::Sequence& sequence,
                           const Catalog& catalog);

}  // namespace hw::panels
