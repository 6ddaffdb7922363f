#pragma once
// A sequence as the program text of one controller: the results of Language::write and Language::read.
#include <string>
#include <vector>

#include "core/sequence/sequence.h"

namespace hw {

struct SequenceText {
  std::string text;
  /// The step of each line, counted from 0 through the whole list, loops included; -1: none.
  std::vector<int> step_of_line;
  /// Remarks, with their steps, on what the controller does differently from the sequence.
  std::vector<std::string> remarks;
  /// A remark on the tool that the text switches, to be shown before it runs; empty: no tool.
  std::string tool;
};

struct SequenceRead {
  sequence::Sequence sequence;
  /// Remarks on parts of the text that the steps do not show.
  std::vector<std::string> remarks;
};

}  // namespace hw
