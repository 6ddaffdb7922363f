#pragma once
// Draws small type beside a number, in as many words as fit.
#include <cmath>

#include "gui/surface/ui.h"
#include "gui/widgets/text.h"

namespace hw::panels {

inline constexpr int least_words = 4;

/// Draws a line of small type: `words(0)`, or the next shorter words up to `words(least_words)`, or nothing
/// if none fits. Returns its width.
template <class Words>
float draw_what_fits(gui::Ui& ui, ImVec2 at, float room, bool right_aligned, const Words& words) {
  for (int brevity = 0; brevity <= least_words; ++brevity) {
    const auto text = words(brevity);
    const float width = std::ceil(gui::text_width(ui, gui::Face::small, text));
    if (width > room) continue;
    gui::draw_text(ui, ImVec2(right_aligned ? at.x + room - width : at.x, at.y), gui::Face::small,
                   ui[gui::Tone::ink2], text);
    return width;
  }
  return 0;
}

}  // namespace hw::panels
