#pragma once
// What stands in small type beside or under the number of an axis.
#include <imgui.h>

#include "gui/model/units_format.h"
#include "gui/shell/frame.h"
#include "gui/surface/theme.h"
#include "gui/widgets/digits.h"
#include "gui/widgets/icons.h"

namespace hw::panels {

struct Caption {
  gui::NumberText words;
  gui::Tone tone = gui::Tone::ink2;
  gui::Icon mark = gui::Icon::none;
};
/// About the number: where it comes from, or what is wrong with it. `brief`: without when.
Caption about_number(gui::Frame& frame, AxisId axis, bool brief = false);
/// Mark and words, from `at` on; the brief words where the others do not fit. Registers `dro/X/provenance`.
/// Returns their width in pixels.
float draw_about_number(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px);
/// "2400 steps" of a real unit; else empty.
gui::NumberText steps_behind(const gui::Frame& frame, AxisId axis);
/// Where it goes and how fast, or what a limit still lets it do. `whole`: with the target.
gui::NumberText where_to(const gui::Frame& frame, AxisId axis, bool whole);
/// What it does and how many commands wait in its queue, as wordy as there is room: "200 000 counts/s, queue
/// 12 of 200", "200 000/s, queue 12", "queue 12"; of a servo axis also how far it is from its command.
/// Returns its width in pixels; 0: nothing, or no room for any.
float draw_at_work(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px, bool right_aligned);
/// draw_at_work() has anything to say.
bool says_something(const gui::Frame& frame, AxisId axis);
/// "5.000/s", beside a position that says the unit.
gui::NumberText format_brief_speed(Pps speed, const gui::DisplayUnit& unit);
/// How far the number is to be believed.
gui::DigitsState digits_state(const Snapshot& now, std::size_t axis, Instant clock);
/// The number as it shall be read: "-" while nothing was ever heard.
gui::NumberText shown_position(const AxisState& state, const gui::DisplayUnit& unit);
/// Registers `dro/X/steps`.
void show_steps(gui::Frame& frame, AxisId axis, const gui::Rect& where);

}  // namespace hw::panels
