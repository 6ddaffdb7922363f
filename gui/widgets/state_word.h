#pragma once
// The state of an axis or controller by shape, word and colour at once: a grey print must still be readable.
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

/// Width of shape and word, in pixels.
float state_word_width(const Ui& ui, State state, Face face);
/// At an exact place: ends at `right.x`, in a line of the face. Registers `id` when it is not empty. With
/// less than `room_px` it uses smaller type, then only the shape.
void draw_state_right(Ui& ui, std::string_view id, ImVec2 right, State state, Face face = Face::title_bold,
                      float room_px = 1e6f);

}  // namespace hw::gui
