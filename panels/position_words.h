#pragma once
// What stands in small type beside or under the number of an axis.
#include "gui/frame.h"
#include "gui/theme.h"
#include "gui/units_format.h"
#include "gui/widgets/digits.h"

namespace hw::panels {

struct Caption {
  gui::NumberText words;
  gui::Tone tone = gui::Tone::ink2;
};
/// About the number: steps, or what is wrong with it.
Caption about_number(gui::Frame& frame, AxisId axis);
/// Where it goes and how fast, or what a limit still lets it do. `whole`: with the target.
gui::NumberText where_to(const gui::Frame& frame, AxisId axis, bool whole);
/// How far the number is to be believed.
gui::DigitsState digits_state(const Snapshot& now, std::size_t axis, Instant clock);
/// The number as it shall be read: "-" while nothing was ever heard.
gui::NumberText shown_position(const AxisState& state, const gui::DisplayUnit& unit);
/// Registers `dro/X/steps`.
void show_steps(gui::Frame& frame, AxisId axis, const gui::Rect& where);

}  // namespace hw::panels
