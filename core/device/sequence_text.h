#pragma once
// A sequence as the program text of one controller: what Language::write makes of it, and Language::read of
// the text.
#include <string>
#include <vector>

#include "core/sequence/sequence.h"

namespace hw {

struct SequenceText {
  std::string text;
  /// Which step each line of the text is of, counted through the whole list, loops entered, from 0; -1: of
  /// none.
  std::vector<int> step_of_line;
  /// What the controller does in another way than the sequence says, each with its step.
  std::vector<std::string> remarks;
  /// What is to be known before it is run of the tool that it switches; empty: it has none.
  std::string tool;
};

struct SequenceRead {
  sequence::Sequence sequence;
  /// What the text has that the steps do not show, in sentences.
  std::vector<std::string> remarks;
};

}  // namespace hw
