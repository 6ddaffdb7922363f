#pragma once
// Keeps rejected input in the fields of blocks while another block is chosen. The input reappears when its
// block is opened. The blocks cannot run before it is corrected.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "panels/blocks/block_rows.h"
#include "panels/blocks/step_form.h"

namespace hw::panels {

class BlockDrafts {
 public:
  /// Call once a frame and after each change. Finds blocks that have moved, and drops the drafts of blocks
  /// that were removed or changed in another way.
  void follow(const sequence::Editor& editor, const BlockRows& rows);
  void keep(const sequence::StepPath& of, StepForm::Draft draft);
  /// Takes the draft of a block out of here; empty: it has none.
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
