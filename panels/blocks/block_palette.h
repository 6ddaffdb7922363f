#pragma once
// Where new blocks come from: by a click, or by typing the beginning of a name. Ids: `blocks/add_by_name`,
// `blocks/add/move`.
#include <optional>
#include <string>

#include "core/sequence/sequence.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class BlockPalette {
 public:
  /// At ImGui's cursor; what is to be added. `all`: before anything is typed, too.
  std::optional<sequence::Step::Body> draw(gui::Frame& frame, const sequence::Sequence& of, bool all);

 private:
  std::string wanted_;  ///< typed to find a block by its name
};

}  // namespace hw::panels
