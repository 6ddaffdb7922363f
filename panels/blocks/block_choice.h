#pragma once
// Which blocks of the list are chosen: none, then the next one comes to the end; one; or several that stand
// behind each other.
#include <cstdint>
#include <optional>

#include "core/sequence/editor.h"
#include "panels/blocks/block_rows.h"

namespace hw::panels {

class BlockChoice {
 public:
  /// Once a frame, and behind each change.
  void follow(const sequence::Editor& editor, BlockRows& rows);
  void choose(std::optional<sequence::StepPath> path) { head_ = std::move(path), anchor_.reset(); }
  void choose(const sequence::StepSpan& span);
  /// From the one that was chosen first up to this one, as Shift does it.
  void extend(sequence::StepPath path);
  /// The same up or down by one within their list.
  void extend(const sequence::Editor& editor, int by);

  /// The one that was touched last; of several its fields are not shown.
  [[nodiscard]] const std::optional<sequence::StepPath>& head() const { return head_; }
  /// Of one that is chosen.
  [[nodiscard]] sequence::StepSpan span() const;
  [[nodiscard]] bool any() const { return head_.has_value(); }
  [[nodiscard]] bool several() const { return head_ && span().count > 1; }
  [[nodiscard]] int row() const { return row_; }  ///< of the head; -1: none
  [[nodiscard]] bool has_row(int row) const { return row >= first_row_ && row < behind_row_; }

 private:
  std::optional<sequence::StepPath> head_, anchor_;
  int row_ = -1, first_row_ = -1, behind_row_ = -1;
  std::uint64_t loads_ = 0;  ///< Editor::loads() then
};

}  // namespace hw::panels
