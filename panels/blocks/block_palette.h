#pragma once
// Adds new blocks, by a click or by typing the beginning of a name. Blocks that the controller can never run
// are grey; their tips say why. Ids: `blocks/add_by_name`, `blocks/add/move`.
#include <optional>
#include <string>
#include <vector>

#include "core/sequence/sequence.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Candidates for a new block. The first candidate that the controller can do is added.
using BlockCandidates = std::vector<sequence::Step::Body>;

class BlockPalette {
 public:
  /// Draws at ImGui's cursor. Returns the candidates for the block to add; empty: none. `all`: all blocks are
  /// listed before the user types.
  BlockCandidates draw(gui::Frame& frame, const sequence::Sequence& of, bool all);

 private:
  void find_unavailable(gui::Frame& frame, const sequence::Sequence& of);

  std::string wanted_;                ///< typed to find a block by its name
  std::vector<std::string> why_not_;  ///< by entry; empty: the controller can do it
  sequence::Sequence asked_for_;      ///< frame of the sequence for which `why_not_` was worked out
};

}  // namespace hw::panels
