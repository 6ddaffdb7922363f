#pragma once
// What two recorded steps are in numbers, and whether the newer one is better. Ids:
// `tuning/measure/overshoot`, `/before`, `/change`.
#include "gui/frame.h"
#include "gui/step_response.h"

namespace hw::panels {

inline constexpr float step_table_height = 32 + 6 * 26 + 8;

struct TwoSteps {
  int number = 0;  ///< of the run; 0: none
  const gui::StepMeasures& now;
  int before = 0;  ///< 0: none
  const gui::StepMeasures& was;
};
/// At ImGui's cursor, `width` logical.
void draw_step_table(gui::Frame& frame, const TwoSteps& steps, float width);

}  // namespace hw::panels
