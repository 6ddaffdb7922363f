#include "panels/blocks/block_rows.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/sequence/steps_in.h"

namespace hw::panels {

bool BlockRows::follow(const sequence::Editor& editor) {
  if (std::exchange(version_, editor.version()) == editor.version() && of_ == editor.shared()) return false;
  of_ = editor.shared();
  rows_.clear();
  add(of_->steps, -1, 0);
  return true;
}

void BlockRows::add(const sequence::StepList& steps, int parent, int depth) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    rows_.push_back({&steps[i], i, parent, depth});
    if (const sequence::StepList* inner = steps_in(steps[i]))
      add(*inner, static_cast<int>(rows_.size()) - 1, depth + 1);
  }
}

sequence::StepPath BlockRows::path(std::size_t row) const {
  sequence::StepPath path;
  for (int r = static_cast<int>(row); r >= 0; r = rows_[ix(r)].parent) path.push_back(rows_[ix(r)].place);
  std::reverse(path.begin(), path.end());
  return path;
}

std::size_t BlockRows::behind(std::size_t row) const {
  std::size_t next = row + 1;
  while (next < rows_.size() && rows_[next].depth > rows_[row].depth) ++next;
  return next;
}

void BlockRows::forget_words() {
  for (Row& row : rows_) row.words.reset();
}

const BlockRows::Words& BlockRows::words(std::size_t row, const sequence::Look& look) {
  Row& r = rows_[row];
  if (!r.words) {
    r.words = std::make_unique<Words>();
    for (const std::size_t place : path(row))
      r.words->number += fmt::format("{}{}", r.words->number.empty() ? "" : ".", place + 1);
    r.words->title = sequence::title_of(r.step->body);
    r.words->summary = sequence::summary_of(r.step->body, *of_, look);
  }
  return *r.words;
}

int BlockRows::row_of(const std::optional<sequence::StepPath>& path) const {
  if (!path || path->empty()) return -1;
  int row = -1;
  const sequence::StepList* list = &of_->steps;
  for (const std::size_t place : *path) {
    if (!list || place >= list->size()) return -1;
    ++row;
    for (std::size_t i = 0; i < place; ++i) {
      const sequence::StepList* inner = steps_in((*list)[i]);
      row += 1 + (inner ? sequence::count_steps(*inner) : 0);
    }
    list = steps_in((*list)[place]);
  }
  return row;
}

}  // namespace hw::panels
