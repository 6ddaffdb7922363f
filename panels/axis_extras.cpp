#include "panels/axis_extras.h"

#include "gui/axis_look.h"
#include "gui/tab.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float line_height = 28;

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

/// A small switch: lamp and word. Returns where it ends.
float draw_power(Frame& f, AxisId axis, ImVec2 at) {
  Ui& ui = f.ui;
  const AxisState& a = f.now.axes[axis.index];
  const std::string_view word = !f.connected() ? "power?" : a.enabled ? "power on" : "power off";
  const float width = ui.px(22) + std::ceil(text_width(ui, Face::small, word)) + ui.px(8);
  ImGui::SetCursorScreenPos(at);
  const Touch t = touch(ui,
                        {.id = Path("dro/{}/power", f.catalog.axes[axis.index].name),
                         .kind = Kind::toggle,
                         .label = "Motor power",
                         .value = a.enabled ? "on" : "off",
                         .disabled = f.connected() ? "" : "There is no link.",
                         .tip = "Switches the motor's current. Without it the axis is loose."},
                        ImVec2(width, ui.px(line_height)));
  if (t.hovered && t.enabled) draw_fill(ui, t.rect, ui[Tone::hover]);
  const float middle = std::floor(t.rect.centre().y);
  draw_lamp(ui, ImVec2(at.x + ui.px(10), middle), 10, LampShape::round,
            !f.connected() ? LampState::unknown
            : a.enabled    ? LampState::on
                           : LampState::off);
  draw_text_line(ui, at.x + ui.px(22), t.rect.max.x, middle, Face::small,
                 ui[a.enabled ? Tone::ink : Tone::ink2], word);
  draw_ring(ui, t);
  if (t.clicked) f.send(intent::SetPower(axis.index, !a.enabled));
  return t.rect.max.x;
}

}  // namespace

float axis_extras_height(const Catalog& c, AxisId axis) {
  const AxisInfo& info = c.axes[axis.index];
  return info.switchable || info.encoder ? line_height : 0;
}

void draw_axis_extras(Frame& f, AxisId axis, ImVec2 at, float width) {
  if (axis_extras_height(f.catalog, axis) == 0) return;
  Ui& ui = f.ui;
  const AxisInfo& info = f.catalog.axes[axis.index];
  const AxisState& a = f.now.axes[axis.index];
  const float middle = std::floor(at.y + ui.px(line_height / 2)), right = at.x + width;
  const bool old = !f.connected() || is_old(f.now, axis.index, f.clock);
  float x = info.switchable ? draw_power(f, axis, ImVec2(at.x - ui.px(4), at.y)) : at.x;
  float end = right;
  if (info.encoder && a.has_encoder) {
    const NumberText number = format_number(static_cast<double>(a.encoder.value), 0);
    const float digits = std::ceil(text_width(ui, Face::small_bold, number));
    const float word = std::ceil(text_width(ui, Face::small, "encoder")) + ui.px(6);
    draw_text_line(ui, right - digits, right + 1, middle, Face::small_bold, ui[old ? Tone::ink3 : Tone::ink],
                   number);
    draw_text_line(ui, right - digits - word, right, middle, Face::small, ui[Tone::ink2], "encoder");
    end = right - digits - word;
    show(ui,
         {Path("dro/{}/encoder", info.name),
          Kind::text,
          "Encoder",
          number,
          {},
          false,
          "Encoder position in counts"},
         {ImVec2(end, at.y), ImVec2(right, at.y + ui.px(line_height))});
  }
  const bool moving = is_motion(state_of(f.now, axis.index, f.clock));
  const std::string_view phase = moving ? word_of(a.phase) : word_of(a.error);
  x += ui.px(8);
  const float phase_width = std::ceil(text_width(ui, Face::small, phase));
  const float phase_end = std::min(end - ui.px(8), x + phase_width);
  if (x + phase_width <= phase_end)  // half a word says nothing
    draw_text_line(ui, x, phase_end + 1, middle, Face::small, ui[moving ? Tone::motion : Tone::fault], phase);
  show(ui,
       {Path("dro/{}/phase", info.name),
        Kind::text,
        "Ramp",
        phase.empty() && !moving ? "at rest" : phase,
        {},
        false,
        phase},
       {ImVec2(x, at.y), ImVec2(std::max(x, phase_end), at.y + ui.px(line_height))});
  const NumberText speed = format_speed(a.speed, f.tab.unit(axis));
  show(ui, {Path("dro/{}/speed", info.name), Kind::text, "Speed", speed, {}, false, {}},
       {ImVec2(x, at.y), ImVec2(std::max(x, phase_end), at.y + ui.px(line_height))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(line_height)));
}

}  // namespace hw::panels
