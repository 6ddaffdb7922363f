#pragma once
// Draws and makes the small type beside or below the number of an axis.
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
/// The origin of the number, or its fault. `brief`: without the time.
Caption about_number(gui::Frame& frame, AxisId axis, bool brief = false);
/// Draws mark and words from `at` on, the brief words if the long words do not fit. Registers
/// `dro/X/provenance`. Returns their width in pixels.
float draw_about_number(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px);
/// "2400 steps" behind a real unit; else empty.
gui::NumberText steps_behind(const gui::Frame& frame, AxisId axis);
/// Target and speed, or the motion that a limit still allows. `whole`: with the target.
gui::NumberText where_to(const gui::Frame& frame, AxisId axis, bool whole);
/// Activity and number of queued commands, in as many words as fit: "200 000 counts/s, queue 12 of 200", "200
/// 000/s, queue 12", "queue 12"; a servo axis adds its distance from the command. Returns its width in
/// pixels; 0: nothing, or no room for any.
float draw_at_work(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px, bool right_aligned);
/// Whether draw_at_work() would draw words.
bool shows_work(const gui::Frame& frame, AxisId axis);
/// "5.000/s", for a place beside a position that shows the unit.
gui::NumberText format_brief_speed(Pps speed, const gui::DisplayUnit& unit);
/// How far the number can be trusted.
gui::DigitsState digits_state(const Snapshot& now, std::size_t axis, Instant clock);
/// The number to show: "-" before any was received.
gui::NumberText shown_position(const AxisState& state, const gui::DisplayUnit& unit);
/// Registers `dro/X/steps`.
void show_steps(gui::Frame& frame, AxisId axis, const gui::Rect& where);

}  // namespace hw::panels
