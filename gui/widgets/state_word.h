#pragma once
// The state of an axis or controller by shape, word and colour together, so that it can be read without
// colour.
#include <string_view>

#include "gui/model/axis_look.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

struct StateLook {
  Icon icon;
  std::string_view word;   ///< capitals, for an axis
  std::string_view small;  ///< for the second line of a tab
  Tone tone;
};
const StateLook& look_of(State state);

/// The width of shape and word together, in pixels.
float state_word_width(const Ui& ui, State state, Face face);
/// Draws the state in a line of the face that ends at `right.x`. Registers `id` when it is not empty. If the
/// state is wider than `room_px`, it is drawn in smaller type, then as the shape alone.
void draw_state_right(Ui& ui, std::string_view id, ImVec2 right, State state, Face face = Face::title_bold,
                      float room_px = 1e6f);

}  // namespace hw::gui
