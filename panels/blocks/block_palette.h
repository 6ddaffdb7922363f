#pragma once
// Adds new blocks, by a click or by typing the beginning of a name. Blocks that the controller can never run
// are grey, and say why. Ids: `blocks/add_by_name`, `blocks/add/move`.
#include <optional>
#include <string>
#include <vector>

#include "core/sequence/sequence.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Candidates for a new block: the first that the controller can do is added.
using BlockWays = std::vector<sequence::Step::Body>;

class BlockPalette {
 public:
  /// Draws at ImGui's cursor. Returns the block to add; empty: none. `all`: list all blocks before anything
  /// is typed.
  BlockWays draw(gui::Frame& frame, const sequence::Sequence& of, bool all);

 private:
  void find_what_cannot_be(gui::Frame& frame, const sequence::Sequence& of);

  std::string wanted_;                ///< typed to find a block by its name
  std::vector<std::string> why_not_;  ///< by entry; empty: the controller can do it
  sequence::Sequence asked_for_;      ///< frame of the sequence for which that was found out
};

}  // namespace hw::panels
