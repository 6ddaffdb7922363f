#pragma once
// Turns the text of the chosen program into blocks, as far as blocks can hold it. Ids: `blocks/replace_all`.
#include <memory>
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

class TextToBlocks {
 public:
  /// Why the text cannot be turned into blocks; empty: it can be tried.
  [[nodiscard]] static std::string_view why_not(const gui::Frame& frame);
  /// Turns the text into blocks; asks first if the blocks have unsaved changes. A toast shows the result.
  void start(gui::Frame& frame);
  void draw_dialog(gui::Frame& frame);
  /// Called by other panels. Shows the Blocks panel, which asks first if its blocks have unsaved changes.
  static void show(gui::Frame& frame);

 private:
  static void read(gui::Frame& frame);

  bool asking_ = false;
};

}  // namespace hw::panels
