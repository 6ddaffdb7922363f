#pragma once
// The windows that layout.h places in a frame, and the borders between them.
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

/// Logical. Nothing may cover the top bar, because STOP ALL is there.
inline constexpr float top_bar_height = 56;

/// One of the five windows of a frame. Panels are drawn between begin and end; `padding` logical.
void begin_region(Ui& ui, const char* name, const Rect& where, Tone ground, ImVec2 padding = ImVec2(16, 0),
                  bool scrolls = false);
void end_region();
/// Makes the padding of the current window usable for drawing and pressing; ImGui clips half of it. Pop the
/// clip rectangle at the window's end.
void use_whole_window();

/// Brings the current window in front of windows that appeared earlier. Open lists and dialogs stay above it.
void bring_to_front();

struct SplitRange {
  float min, max, normal;
};
/// A border that can be dragged. A double click restores the normal size; + and - move a focused border.
/// `size` is logical; `towards` is +1 when dragging right (down) makes it larger. Returns true when `size`
/// changed.
bool splitter(Ui& ui, std::string_view id, const Rect& border, bool vertical, float& size,
              const SplitRange& range, int towards);

}  // namespace hw::gui
