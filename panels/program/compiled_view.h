#pragma once
// Shows the compiled program: the controller's low-level lines, each with its source line. Ids:
// `program/listing`.
#include <string>
#include <vector>

#include "gui/model/program_texts.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class CompiledView {
 public:
  /// Draws at ImGui's cursor, logical size.
  void draw(gui::Frame& frame, int slot, float width, float height);

 private:
  void follow(gui::ProgramTexts& texts, int slot);

  std::uint64_t version_ = 0;
  int slot_ = -1;
  std::string whole_;              ///< for scripts and readers
  std::vector<int> source_lines_;  ///< of each low-level line, from 0; -1: none
};

}  // namespace hw::panels
