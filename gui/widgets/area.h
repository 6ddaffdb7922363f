#pragma once
// Parts of the window, from the layout's logical boxes.
#include "gui/surface/layout.h"
#include "gui/surface/ui.h"
#include "gui/widgets/region.h"

namespace hw::gui {

inline Rect in_pixels(const Ui& ui, const Box& box) {
  return {ui.px(box.x, box.y), ImVec2(ui.px(box.right()), ui.px(box.bottom()))};
}

/// Begins a child of the current window from the cursor to the given height (0: the rest), scrolling when
/// needed. `padding` at left and right.
void begin_part(Ui& ui, const char* name, float width, float height, Tone ground, float padding = 16,
                bool scrolls = true);
void end_part();

/// Hairline between two parts.
void line_right_of(Ui& ui, const Rect& r);
void line_below(Ui& ui, const Rect& r);

}  // namespace hw::gui
