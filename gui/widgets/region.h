#pragma once
// The windows of a frame that layout.h places, and the borders between them.
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

/// Logical. Nothing may lie over it: STOP ALL stands there.
inline constexpr float top_bar_height = 56;

/// One of the five windows of a frame. Panels are drawn between begin and end; `padding` logical.
void begin_region(Ui& ui, const char* name, const Rect& where, Tone ground, ImVec2 padding = ImVec2(16, 0),
                  bool scrolls = false);
void end_region();
/// ImGui clips half of a window's padding: from here on its whole inside can be drawn on and pressed. Pop the
/// clip rectangle at the window's end.
void use_whole_window();

/// The current window, which appeared later than its neighbours; open lists and dialogs stay above it.
void bring_to_front();

struct SplitRange {
  float min, max, normal;
};
/// A draggable border; double click restores. `size` is logical; `towards`: +1 when dragging right (down)
/// makes it larger. With the focus ring, + and - move it. True when it changed.
bool splitter(Ui& ui, std::string_view id, const Rect& border, bool vertical, float& size,
              const SplitRange& range, int towards);

}  // namespace hw::gui
