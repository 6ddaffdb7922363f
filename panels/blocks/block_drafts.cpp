#include "panels/blocks/block_drafts.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"

namespace hw::panels {

namespace seq = sequence;

void BlockDrafts::follow(const seq::Editor& editor, const BlockRows& rows) {
  if (std::exchange(loads_, editor.loads()) != editor.loads()) kept_.clear();
  if (std::exchange(version_, editor.version()) == editor.version() || kept_.empty()) return;
  for (Kept& kept : kept_) place(kept, editor, rows);
  std::erase_if(kept_, [](const Kept& kept) { return kept.row < 0; });
  std::sort(kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.row < b.row; });
}

/// Finds the present place of the block: the old place, else the first block with the same content.
void BlockDrafts::place(Kept& kept, const seq::Editor& editor, const BlockRows& rows) {
  const auto is_it = [&kept](const seq::Step* step) { return step && kept.draft.is_of(step->body); };
  kept.row = is_it(editor.at(kept.path)) ? rows.row_of(kept.path) : -1;
  for (std::size_t row = 0; kept.row < 0 && row < rows.size(); ++row)
    if (is_it(&rows.step(row))) kept.row = static_cast<int>(row), kept.path = rows.path(row);
  kept.here = fmt::format("{} Correct it before the next run.", kept.draft.problem);
  std::string number;
  for (const std::size_t at : kept.path) number += fmt::format("{}{}", number.empty() ? "" : ".", at + 1);
  kept.anywhere = fmt::format("Correct block {} first. {}", number, kept.draft.problem);
}

void BlockDrafts::keep(const seq::StepPath& of, StepForm::Draft draft) {
  if (draft.problem.empty()) return;
  std::erase_if(kept_, [&of](const Kept& kept) { return kept.path == of; });
  kept_.push_back({of, std::move(draft)});
  version_ = ~std::uint64_t{0};  // the next follow() finds its row
}

StepForm::Draft BlockDrafts::take(const seq::StepPath& of) {
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&of](const Kept& kept) { return kept.path == of; });
  if (found == kept_.end()) return {};
  StepForm::Draft draft = std::move(found->draft);
  kept_.erase(found);
  return draft;
}

std::string_view BlockDrafts::problem_of(int row) const {
  for (const Kept& kept : kept_)
    if (kept.row == row) return kept.here;
  return {};
}

std::string_view BlockDrafts::problem() const {
  return kept_.empty() ? std::string_view() : std::string_view(kept_.front().anywhere);
}

int BlockDrafts::before(int row) const {
  return static_cast<int>(
      std::count_if(kept_.begin(), kept_.end(), [row](const Kept& kept) { return kept.row < row; }));
}

int BlockDrafts::next(int row) const {
  for (const Kept& kept : kept_)
    if (kept.row > row) return kept.row;
  return -1;
}

}  // namespace hw::panels
