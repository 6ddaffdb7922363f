#pragma once
// The measures of the left column in logical pixels, for each number of axes and kind of window. They depend
// on nothing else, so that no message, state, unit or refusal shifts a motion control by a pixel.
#include "gui/shell/frame.h"

namespace hw::panels {

struct LeftColumn {
  // ---- the block of an axis
  float above = 0, below = 0;  ///< space, with the hairline at its top
  float head = 20;             ///< its name and state
  float digits = 36;           ///< a slot: smaller type is centred in it
  float caption = 0;           ///< below the number; 0: beside it
  float extras = 0;            ///< line for power, ramp and encoder, of axes that need it
  float travel = 0;            ///< the travel bar, the first part left out of a low column
  // ---- jog
  float title = 40, reason = 36;
  float cell = 48, between_steps = 8, below_steps = 0;
  float wide_stop = 40;  ///< height of a Stop as wide as the column
  bool speed_in_title = false, speed_over_slider = false;
  // ---- go and home
  float go_title = 36, go_row = 36, go_control = 32;
  bool together_in_title = false;

  [[nodiscard]] float block() const;
};

LeftColumn column_of(const gui::Frame& frame);

}  // namespace hw::panels
