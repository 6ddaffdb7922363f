#pragma once
// Rejected input in the fields of blocks, kept while another block is chosen. Nothing runs before the input
// is corrected. It reappears when its block is opened.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "panels/blocks/block_rows.h"
#include "panels/blocks/step_form.h"

namespace hw::panels {

class BlockDrafts {
 public:
  /// Call once a frame and after each change. Finds blocks that have moved again, and forgets those that are
  /// gone or were changed in another way.
  void follow(const sequence::Editor& editor, const BlockRows& rows);
  void keep(const sequence::StepPath& of, StepForm::Draft draft);
  /// Empty: no draft.
  StepForm::Draft take(const sequence::StepPath& of);
  void forget() { kept_.clear(); }

  /// "Speed: This is not a number. Mend it before the next run."; empty: the block has no problem.
  [[nodiscard]] std::string_view problem_of(int row) const;
  /// The first problem, with its block's number; empty: none.
  [[nodiscard]] std::string_view problem() const;
  /// Number of drafts before `row`.
  [[nodiscard]] int before(int row) const;
  /// Row of the next draft after `row`; -1: none.
  [[nodiscard]] int next(int row) const;

 private:
  struct Kept {
    sequence::StepPath path;
    StepForm::Draft draft;
    int row = -1;
    std::string here{}, anywhere{};
  };
  void place(Kept& kept, const sequence::Editor& editor, const BlockRows& rows);

  std::vector<Kept> kept_;  ///< by row
  std::uint64_t version_ = ~std::uint64_t{0}, loads_ = 0;
};

}  // namespace hw::panels
