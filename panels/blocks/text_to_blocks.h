#pragma once
// The text of the chosen program becomes the blocks, as far as blocks can hold it. Ids: `blocks/replace_all`.
#include <memory>
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

class TextToBlocks {
 public:
  /// Empty: it can be tried.
  [[nodiscard]] static std::string_view why_not(const gui::Frame& frame);
  /// Asks first where blocks have changes that are in no file. What came of it is said as a toast.
  void start(gui::Frame& frame);
  void draw_dialog(gui::Frame& frame);
  /// From another panel: leads to the blocks, which ask where they have such changes.
  static void show(gui::Frame& frame);

 private:
  static void read(gui::Frame& frame);

  bool asking_ = false;
};

}  // namespace hw::panels
