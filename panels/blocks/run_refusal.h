#pragma once
// Why the blocks were not run, beside Run until they are changed or run again. Ids: `blocks/run_refused`,
// `blocks/run_refused/close`, `blocks/run_refused/show`.
#include <string>

#include "core/device/sequence_text.h"
#include "panels/blocks/block_rows.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class RunRefusal {
 public:
  /// `text`: what was to be run.
  void tell(std::string words, std::string text);
  void forget() { words_.clear(); }
  /// Draws beside `bar`. Returns the row to be shown, if the user asks for the block that the words name; -1:
  /// none.
  int draw(gui::Frame& frame, const SequenceText& text, const BlockRows& rows, const gui::Rect& bar);

 private:
  std::string words_, text_;  ///< no words: nothing was refused
  RefusalCard card_;
};

}  // namespace hw::panels
