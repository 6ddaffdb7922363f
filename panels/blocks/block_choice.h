#pragma once
// The chosen blocks of the list: none (a new block is added at the end), a single block, or several
// consecutive blocks.
#include <cstdint>
#include <optional>

#include "core/sequence/editor.h"
#include "panels/blocks/block_rows.h"

namespace hw::panels {

class BlockChoice {
 public:
  /// Call once a frame and after each change.
  void follow(const sequence::Editor& editor, BlockRows& rows);
  void choose(std::optional<sequence::StepPath> path) { head_ = std::move(path), anchor_.reset(); }
  void choose(const sequence::StepSpan& span);
  /// Extends the choice from the block chosen first to the block at `path`, as Shift does.
  void extend(sequence::StepPath path);
  /// Extends the choice by one block up or down within its list.
  void extend(const sequence::Editor& editor, int by);

  /// The block touched last. Its fields are hidden while several blocks are chosen.
  [[nodiscard]] const std::optional<sequence::StepPath>& head() const { return head_; }
  /// The chosen blocks. At least one block must be chosen.
  [[nodiscard]] sequence::StepSpan span() const;
  [[nodiscard]] bool any() const { return head_.has_value(); }
  [[nodiscard]] bool several() const { return head_ && span().count > 1; }
  [[nodiscard]] int row() const { return row_; }  ///< row of the head; -1: none
  [[nodiscard]] bool has_row(int row) const { return row >= first_row_ && row < behind_row_; }

 private:
  std::optional<sequence::StepPath> head_, anchor_;
  int row_ = -1, first_row_ = -1, behind_row_ = -1;
  std::uint64_t loads_ = 0;  ///< Editor::loads() at the last follow()
};

}  // namespace hw::panels
