#pragma once
// Shows beside Run why the blocks were not run, until they are changed or run again. Ids:
// `blocks/run_refused`, `blocks/run_refused/close`, `blocks/run_refused/show`.
#include <cstdint>
#include <optional>
#include <string>

#include "core/device/sequence_text.h"
#include "panels/blocks/block_rows.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class RunRefusal {
 public:
  /// `text` is that of the blocks. `from` is the row from which the run was to begin; nullopt: all blocks.
  void set(std::string words, std::string text, std::optional<int> from = {});
  void forget() { words_.clear(); }
  /// Draws beside `bar`. Returns the row to show if the user asks for the block that the words name, or from
  /// which the run was to begin; -1: none.
  int draw(gui::Frame& frame, const SequenceText& text, const BlockRows& rows, const gui::Rect& bar);

 private:
  void find_row(const SequenceText& text, const BlockRows& rows);

  std::string words_, text_;  ///< empty words: no run was refused
  std::optional<int> from_;
  int row_ = -1;                                ///< row of the block that the refusal is about
  std::string show_;                            ///< "Show block 3.1"; empty: no block is concerned
  std::uint64_t found_in_ = ~std::uint64_t{0};  ///< BlockRows::version()
  RefusalCard card_;
};

}  // namespace hw::panels
