#pragma once
// Where new blocks come from: by a click, or by typing the beginning of a name. Ids: `blocks/add_by_name`,
// `blocks/add/move`.
#include <optional>
#include <string>
#include <vector>

#include "core/sequence/sequence.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// What a new block could be: the first of these that the controller can do.
using BlockWays = std::vector<sequence::Step::Body>;

class BlockPalette {
 public:
  /// At ImGui's cursor; what is to be added, empty: nothing. `all`: before anything is typed, too.
  BlockWays draw(gui::Frame& frame, const sequence::Sequence& of, bool all);

 private:
  std::string wanted_;  ///< typed to find a block by its name
};

}  // namespace hw::panels
