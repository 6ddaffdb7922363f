#pragma once
// The user's step and speed for jogging: on a bus, whose rows share one control, for all its controllers.
// GUI thread.
#include "core/base/units.h"

namespace hw::gui {

class Tab;

/// Chooses the step of a tap and the speed of held jogs. `speed` 0: the controller's own.
void choose_jog(Tab& tab, Steps step, Pps speed);
/// Chooses the speed for all axes, replacing the choices for single axes. 0: the controller's own.
void choose_jog_speed(Tab& tab, Pps of_all);

}  // namespace hw::gui
