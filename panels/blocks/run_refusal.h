#pragma once
// Why the blocks were not run, beside Run until they are changed or run again. Ids: `blocks/run_refused`,
// `blocks/run_refused/close`, `blocks/run_refused/show`.
#include <cstdint>
#include <optional>
#include <string>

#include "core/device/sequence_text.h"
#include "panels/blocks/block_rows.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class RunRefusal {
 public:
  /// `text`: of the blocks. `from`: the row from which on they were to be run; none: all of them.
  void set(std::string words, std::string text, std::optional<int> from = {});
  void forget() { words_.clear(); }
  /// Draws beside `bar`. Returns the row to be shown, if the user asks for the block that the words name, or
  /// from which on the blocks were to be run; -1: none.
  int draw(gui::Frame& frame, const SequenceText& text, const BlockRows& rows, const gui::Rect& bar);

 private:
  void find_row(const SequenceText& text, const BlockRows& rows);

  std::string words_, text_;  ///< no words: nothing was refused
  std::optional<int> from_;
  int row_ = -1;                                ///< the block concerned
  std::string show_;                            ///< "Show block 3.1"; empty: none is concerned
  std::uint64_t found_in_ = ~std::uint64_t{0};  ///< BlockRows::version()
  RefusalCard card_;
};

}  // namespace hw::panels
