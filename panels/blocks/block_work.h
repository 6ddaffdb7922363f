#pragma once
// Writes the blocks in the controller's language on the worker, whenever they have changed.
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/sequence/editor.h"
#include "gui/shell/frame.h"
#include "panels/blocks/written_blocks.h"

namespace hw::panels {

class BlockWork {
 public:
  /// Call once a frame.
  void follow(gui::Frame& frame, const sequence::Editor& editor);
  /// The latest result. It is that of the present blocks if up_to_date(). Each version is a new object.
  [[nodiscard]] const std::shared_ptr<const WrittenBlocks>& written() const { return written_; }
  [[nodiscard]] bool up_to_date() const { return written_->version == wanted_; }
  /// Why there is no text to run; empty: there is one.
  [[nodiscard]] std::string_view why_none(const sequence::Editor& editor) const;

 private:
  std::shared_ptr<const WrittenBlocks> written_ = std::make_shared<const WrittenBlocks>();
  std::shared_ptr<const Catalog> catalog_;  ///< for the worker, which may outlive the tab
  std::uint64_t wanted_ = ~std::uint64_t{0};
  std::shared_ptr<int> under_way_ =
      std::make_shared<int>(0);  ///< expires with this object, so that its jobs are dropped
};

}  // namespace hw::panels
