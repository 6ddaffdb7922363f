#pragma once
// What blocks are shown in: of each axis what the whole console shows it in, else the sequence's own unit.
#include <array>
#include <cstdint>

#include "core/sequence/editor.h"
#include "core/sequence/words.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class BlockLook {
 public:
  /// Once a frame. True: it is another one than before.
  bool follow(const gui::Frame& frame, const sequence::Editor& editor);
  [[nodiscard]] const sequence::Look& look() const { return look_; }

 private:
  sequence::Look look_;
  std::array<gui::DisplayUnit, max_axes> units_;  ///< that it was made of
  std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace hw::panels
