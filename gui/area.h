#pragma once
// A part of the window: an ImGui window without any of its furniture, placed by the layout.
#include "gui/layout.h"
#include "gui/ui.h"

namespace hw::gui {

inline Rect in_pixels(const Ui& ui, const Box& box) {
  return {ui.px(box.x, box.y), ImVec2(ui.px(box.right()), ui.px(box.bottom()))};
}

/// Always followed by end_area(). `padding`: at the left and right, logical.
void begin_area(Ui& ui, const char* name, const Box& box, Tone ground, float padding = 16,
                bool on_top = false);
void end_area();

/// A child of the current window from the cursor to the given height (0: the rest), scrolling when it must.
/// `padding` at left and right.
void begin_part(Ui& ui, const char* name, float width, float height, Tone ground, float padding = 16,
                bool scrolls = true);
void end_part();

/// Hairline between two parts.
void line_right_of(Ui& ui, const Rect& r);
void line_below(Ui& ui, const Rect& r);

}  // namespace hw::gui
