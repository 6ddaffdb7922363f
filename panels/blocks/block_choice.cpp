#include "panels/blocks/block_choice.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/sequence/steps_in.h"

namespace hw::panels {

void BlockChoice::follow(const sequence::Editor& editor, BlockRows& rows) {
  if (std::exchange(loads_, editor.loads()) != editor.loads()) head_.reset();
  if (head_ && (head_->empty() || !editor.at(*head_))) head_.reset();
  if (!head_ || (anchor_ && !editor.at(*anchor_))) anchor_.reset();
  rows.follow(editor);
  row_ = first_row_ = behind_row_ = rows.row_of(head_);
  if (!head_) return;
  const sequence::StepSpan chosen = span();
  sequence::StepPath last = chosen.first;
  last.back() += chosen.count - 1;
  first_row_ = rows.row_of(chosen.first);
  const int last_row = rows.row_of(last);
  behind_row_ = last_row < 0 ? -1 : static_cast<int>(rows.behind(ix(last_row)));
}

void BlockChoice::choose(const sequence::StepSpan& span) {
  head_ = anchor_ = span.first;
  anchor_->back() += span.count - 1;
}

void BlockChoice::extend(sequence::StepPath path) {
  if (head_ && !anchor_) anchor_ = head_;
  head_ = std::move(path);
}

void BlockChoice::extend(const sequence::Editor& editor, int by) {
  if (!head_) return;
  // Works in the list that contains all chosen blocks, however deep the head is inside it.
  const std::size_t level = span().first.size();
  sequence::StepPath next(head_->begin(), head_->begin() + static_cast<std::ptrdiff_t>(level));
  if (by < 0 && next.back() == 0) return;
  next.back() += by < 0 ? -1 : 1;
  if (editor.at(next)) extend(std::move(next));
}

sequence::StepSpan BlockChoice::span() const {
  return anchor_ ? sequence::span_between(*anchor_, *head_) : sequence::StepSpan(*head_);
}

}  // namespace hw::panels
