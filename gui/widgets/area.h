#pragma once
// Draws the parts of the window that the layout has placed (in logical pixels).
#include "gui/surface/layout.h"
#include "gui/surface/ui.h"
#include "gui/widgets/region.h"

namespace hw::gui {

inline Rect in_pixels(const Ui& ui, const Box& box) {
  return {ui.px(box.x, box.y), ImVec2(ui.px(box.right()), ui.px(box.bottom()))};
}

/// Begins a child of the current window at the cursor. Sizes are logical; height 0 takes the rest. It scrolls
/// when its content is higher. `padding` is kept free at the left and right.
void begin_part(Ui& ui, const char* name, float width, float height, Tone ground, float padding = 16,
                bool scrolls = true);
void end_part();

/// A hairline between two parts.
void line_right_of(Ui& ui, const Rect& r);
void line_below(Ui& ui, const Rect& r);

}  // namespace hw::gui
