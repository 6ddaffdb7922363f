#pragma once
// The parts beside the blocks, as far as there is room: the palette at the left, text and path at the right;
// a part without room is one press away. Ids: `blocks/aside`, `blocks/side/Text`, `blocks/side/Path`.
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
  /// Text and path make room for the list, if they have taken its place.
  void show_list(const gui::Frame& frame);
  /// Button of the toolbar that exchanges what shares a place, and its logical width; 0: there is none.
  void draw_switch(gui::Frame& frame);
  [[nodiscard]] float switch_width(const gui::Frame& frame) const;
  /// Draws one part at ImGui's cursor, logical size.
  using DrawPart = std::function<void(float width, float height)>;
  /// The text, and the path below it; one of them if the height is too small for both.
  void draw(gui::Frame& frame, float width, float height, const DrawPart& text, const DrawPart& path);

 private:
  /// The part that the button opens.
  [[nodiscard]] const char* other(const gui::Frame& frame) const;

  bool side_first_ = false, path_first_ = false;
};

}  // namespace hw::panels
