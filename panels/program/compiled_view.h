#pragma once
// What the text becomes in the controller: its low-level lines, each with the line of the text it came from.
// Ids: `program/listing`.
#include <string>
#include <vector>

#include "gui/model/program_texts.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class CompiledView {
 public:
  /// At ImGui's cursor, logical size.
  void draw(gui::Frame& frame, int slot, float width, float height);

 private:
  void follow(gui::ProgramTexts& texts, int slot);

  std::uint64_t version_ = 0;
  int slot_ = -1;
  std::string whole_;              ///< for scripts and readers
  std::vector<int> source_lines_;  ///< of each low-level line, from 0; -1: none
};

}  // namespace hw::panels
