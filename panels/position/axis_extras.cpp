#include "panels/position/axis_extras.h"

#include <algorithm>
#include <cmath>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float extra_line_height = 28;

std::string_view word_of(Phase phase) {
  switch (phase) {
    case Phase::accelerating: return "accelerating";
    case Phase::constant: return "constant speed";
    case Phase::decelerating: return "decelerating";
    case Phase::unknown: break;
  }
  return {};
}

std::string_view word_of(AxisError error) {
  switch (error) {
    case AxisError::limit_minus: return "\u2212 limit error";
    case AxisError::limit_plus: return "+ limit error";
    case AxisError::limit: return "limit error";
    case AxisError::alarm: return "alarm error";
    case AxisError::stalled: return "stalled";
    case AxisError::too_far: return "too far off";
    case AxisError::not_corrected: return "not corrected";
    case AxisError::none: break;
  }
  return {};
}

bool power_known(const Frame& f, AxisId axis) {
  return f.connected() && f.now.axes[axis.index].loop != Loop::unknown;
}

std::string_view power_word(const Frame& f, AxisId axis, bool brief) {
  if (!power_known(f, axis)) return brief ? "?" : "power?";
  const bool on = f.now.axes[axis.index].enabled;
  return brief ? (on ? "on" : "off") : on ? "power on" : "power off";
}

}  // namespace

float power_width(const Frame& f, AxisId axis, bool brief) {
  if (!f.catalog.axes[axis.index].switchable) return 0;
  return f.ui.px(30) + std::ceil(text_width(f.ui, Face::small, power_word(f, axis, brief)));
}

void draw_power(Frame& f, AxisId axis, ImVec2 at, float height, bool brief) {
  Ui& ui = f.ui;
  const AxisState& a = f.now.axes[axis.index];
  ImGui::SetCursorScreenPos(at);
  const Touch t = touch(ui,
                        {.id = Path("dro/{}/power", f.catalog.axes[axis.index].name),
                         .kind = Kind::toggle,
                         .label = "Motor power",
                         .value = a.enabled ? "on" : "off",
                         .disabled = f.no_link(),
                         .tip = "Switches the motor's current. Without it the axis is loose."},
                        ImVec2(power_width(f, axis, brief), ui.px(height)));
  if (t.hovered && t.enabled) draw_fill(ui, t.rect, ui[Tone::hover]);
  const float middle = std::floor(t.rect.centre().y);
  draw_lamp(ui, ImVec2(at.x + ui.px(10), middle), 10, LampShape::round,
            !power_known(f, axis) ? LampState::unknown
            : a.enabled           ? LampState::on
                                  : LampState::off);
  draw_text_line(ui, at.x + ui.px(22), t.rect.max.x, middle, Face::small,
                 ui[a.enabled ? Tone::ink : Tone::ink2], power_word(f, axis, brief));
  draw_ring(ui, t);
  if (t.clicked) f.send(intent::SetPower(axis.index, !a.enabled));
}

void draw_encoder(Frame& f, AxisId axis, ImVec2 at, float room, bool right_aligned) {
  Ui& ui = f.ui;
  const AxisInfo& info = f.catalog.axes[axis.index];
  const AxisState& a = f.now.axes[axis.index];
  if (!info.encoder || !a.has_encoder) return;
  const NumberText number = format_number(static_cast<double>(a.encoder.value), 0);
  const float digits = std::ceil(text_width(ui, Face::small_bold, number));
  const float word = std::ceil(text_width(ui, Face::small, "encoder")) + ui.px(6);
  const bool worded = word + digits <= room;
  const float width = worded ? word + digits : std::min(digits, room);
  const float left = right_aligned ? at.x + room - width : at.x;
  const float middle = at.y + std::floor(ui.line(Face::small) * 0.5f);
  const bool old = !f.connected() || is_old(f.now, axis.index, f.clock);
  if (worded) draw_text_line(ui, left, left + word, middle, Face::small, ui[Tone::ink2], "encoder");
  draw_text_line(ui, left + (worded ? word : 0), left + width + 1, middle, Face::small_bold,
                 ui[old ? Tone::ink3 : Tone::ink], number);
  show(ui,
       {Path("dro/{}/encoder", info.name),
        Kind::text,
        "Encoder",
        number,
        {},
        false,
        "Encoder position in counts"},
       {ImVec2(left, at.y), ImVec2(left + width, at.y + ui.line(Face::small))});
}

std::string_view phase_of(const Frame& f, AxisId axis) {
  const AxisState& a = f.now.axes[axis.index];
  return is_motion(state_of(f.now, axis.index, f.clock)) ? word_of(a.phase) : word_of(a.error);
}

void show_phase(Frame& f, AxisId axis, const Rect& where) {
  const std::string& name = f.catalog.axes[axis.index].name;
  const bool moving = is_motion(state_of(f.now, axis.index, f.clock));
  const std::string_view phase = phase_of(f, axis);
  const NumberText speed = format_speed(f.now.axes[axis.index].speed, f.tab.settings.unit(axis));
  show(f.ui,
       {Path("dro/{}/phase", name),
        Kind::text,
        "Ramp",
        phase.empty() && !moving ? "at rest" : phase,
        {},
        false,
        phase},
       where);
  show(f.ui, {Path("dro/{}/speed", name), Kind::text, "Speed", speed, {}, false, {}}, where);
}

float axis_extras_height(const Catalog& c, AxisId axis) {
  const AxisInfo& info = c.axes[axis.index];
  return info.switchable || info.encoder ? extra_line_height : 0;
}

void draw_axis_extras(Frame& f, AxisId axis, ImVec2 at, float width) {
  if (axis_extras_height(f.catalog, axis) == 0) return;
  Ui& ui = f.ui;
  const float middle = std::floor(at.y + ui.px(extra_line_height / 2));
  const float line = middle - std::floor(ui.line(Face::small) * 0.5f);
  float x = at.x;
  if (const float power = power_width(f, axis, false); power > 0) {
    draw_power(f, axis, ImVec2(at.x - ui.px(4), at.y), extra_line_height, false);
    x += power + ui.px(4);
  }
  const std::string_view phase = phase_of(f, axis);
  const float phase_width = std::ceil(text_width(ui, Face::small, phase));
  const float right = at.x + width, end = std::min(x + phase_width + ui.px(8), right - ui.px(60));
  draw_encoder(f, axis, ImVec2(end, line), right - end, true);
  const bool moving = is_motion(state_of(f.now, axis.index, f.clock));
  if (x + phase_width <= end)  // a part of a word is useless
    draw_text_line(ui, x, end, middle, Face::small, ui[moving ? Tone::motion : Tone::fault], phase);
  show_phase(f, axis, {ImVec2(x, at.y), ImVec2(std::max(x, end), at.y + ui.px(extra_line_height))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(extra_line_height)));
}

}  // namespace hw::panels
