#pragma once
// How far a tap of a jog button or key moves an axis: the chosen step, which is a number in the unit of each
// axis where the axes that share the choice have different ones.
#include <string>

#include "gui/model/tab.h"

namespace hw::gui {

/// The unit whose steps are chosen: the first axis's, without the sign of axes that count against their
/// steps. Its name is that of all units: "mm, °". None, if all axes have the same or some have none of their
/// own.
[[nodiscard]] DisplayUnit unit_of_taps(const Tab& tab);
/// On a bus, the axes of all its devices share the choice.
[[nodiscard]] Steps tap_of(const Tab& tab, AxisId axis);

}  // namespace hw::gui
