#pragma once
// Follows the block that is executed, when all blocks run, or the rest of them from a block on.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class LiveBlock {
 public:
  /// Call once a frame. `blocks`: their present text.
  void follow(gui::Frame& frame, const SequenceText& blocks);
  /// The step that is executed, as SequenceText counts the steps; -1: none of these blocks, or unknown.
  [[nodiscard]] int step() const { return step_; }
  /// "runs", "held here", "waits here", "on its way there"; with "worked out" if the console infers it.
  [[nodiscard]] std::string_view words() const { return words_; }

 private:
  /// The text that the controller has in the slot; null: no text of these blocks.
  const SequenceText* held_in(gui::Frame& frame, int slot, const SequenceText& blocks);
  /// The block of a step of that text; `leads`: the step only leads to that block.
  [[nodiscard]] int block_of(int step, bool& leads) const;

  int step_ = -1;
  std::string_view words_;
  std::shared_ptr<const sequence::Sequence> rest_, whole_;
  std::vector<int> rows_;  ///< sequence::rows_of_rest(); empty: the controller has the text of all blocks
  int begins_at_ = -1;     ///< first block of the rest
};

}  // namespace hw::panels
