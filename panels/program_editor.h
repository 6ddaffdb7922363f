#pragma once
// The editor of one controller's program texts: the toolkit's editor, fed from the texts and the snapshot.
#include <string>
#include <vector>

#include "gui/desk.h"
#include "gui/frame.h"

namespace hw::panels {

class ProgramEditor {
 public:
  /// At ImGui's cursor, logical size.
  void draw(gui::Frame& frame, int slot, float width, float height);
  /// Brings a line (from 0) into sight and puts the caret there.
  void go_to(int slot, int line, int column);
};

}  // namespace hw::panels
