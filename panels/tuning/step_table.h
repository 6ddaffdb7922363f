#pragma once
// Draws two recorded steps in numbers, and whether the newer step is better: a row for each measure, or a
// column if the plots need the height. Ids: `tuning/measure/overshoot`, `/before`, `/change`.
#include "gui/model/step_response.h"
#include "gui/shell/frame.h"

namespace hw::panels {

inline constexpr float step_table_height = 32 + 6 * 26 + 8;
inline constexpr float flat_step_table_height = 36 + 24 + 24 + 40 + 4;

struct TwoSteps {
  int number = 0;  ///< of the run; 0: none
  const gui::StepMeasures& now;
  int before = 0;  ///< 0: none
  const gui::StepMeasures& was;
  const gui::StepScatter& scatter;  ///< a difference must exceed it, if it is known
};
/// Draws at ImGui's cursor, `width` logical.
void draw_step_table(gui::Frame& frame, const TwoSteps& steps, float width);
void draw_flat_step_table(gui::Frame& frame, const TwoSteps& steps, float width);

}  // namespace hw::panels
