#pragma once
// Places the parts beside the blocks: the palette at the left, text and path at the right. A button shows a
// part that does not fit. Ids: `blocks/aside`, `blocks/side/Text`, `blocks/side/Path`.
#include <functional>

#include "gui/shell/frame.h"

namespace hw::panels {

class BlockSides {
 public:
  /// Widths; 0: not shown.
  struct Columns {
    float palette = 0, list = 0, side = 0;
  };
  [[nodiscard]] Columns columns(const gui::Frame& frame) const;
  /// Shows the list again if text and path have taken its place.
  void show_list(const gui::Frame& frame);
  /// The toolbar's button that exchanges parts which share a place, and its logical width; 0: there is no
  /// button.
  void draw_switch(gui::Frame& frame);
  [[nodiscard]] float switch_width(const gui::Frame& frame) const;
  /// Draws a part at ImGui's cursor. Logical size.
  using DrawPart = std::function<void(float width, float height)>;
  /// Draws the text and the path below it, or only one of them if both are too high.
  void draw(gui::Frame& frame, float width, float height, const DrawPart& text, const DrawPart& path);

 private:
  /// The part that the button opens.
  [[nodiscard]] const char* other(const gui::Frame& frame) const;

  bool side_first_ = false, path_first_ = false;
};

}  // namespace hw::panels
