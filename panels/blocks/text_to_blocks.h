#pragma once
// Turns the text of the chosen program into blocks, as far as blocks can hold it. Ids: `blocks/replace_all`.
#include <memory>
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

class TextToBlocks {
 public:
  /// Empty: it can be tried.
  [[nodiscard]] static std::string_view why_not(const gui::Frame& frame);
  /// Asks first if blocks have unsaved changes. A toast shows the result.
  void start(gui::Frame& frame);
  void draw_dialog(gui::Frame& frame);
  /// For other panels: shows the blocks, which ask first if they have unsaved changes.
  static void show(gui::Frame& frame);

 private:
  static void read(gui::Frame& frame);

  bool asking_ = false;
};

}  // namespace hw::panels
