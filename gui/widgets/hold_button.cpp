#include "gui/widgets/hold_button.h"

#include <imgui_internal.h>

#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

void draw_hold(Ui& ui, const Touch& t, std::string_view label, const HoldOptions& o, bool held) {
  ImU32 ink = ui[Tone::ink];
  if (!t.enabled) {
    draw_outline(ui, t.rect, ui[Tone::line]);
    ink = ui[Tone::ink3];
  } else if (held && o.moving) {
    draw_fill(ui, t.rect, ui[Tone::motion]);
    ink = ui[Tone::on_motion];
  } else {
    draw_fill(ui, t.rect, ui[held ? Tone::sel : t.hovered ? Tone::hover : Tone::raised]);
    if (held || !o.moving) draw_outline(ui, t.rect, ui[o.stops ? Tone::fault : Tone::edge]);
    if (o.stops) ink = ui[Tone::fault];
  }
  if (o.moving && !(t.enabled && held))
    draw_motion_edge(ui, t.rect, ui[t.enabled ? Tone::motion : Tone::line]);
  const float middle = t.rect.centre().y;
  if (o.icon == Icon::none) {
    draw_text_centred(ui, t.rect, Face::body_bold, ink, label);
  } else {
    const float apart = label.empty() ? 0 : ui.px(o.height >= 48 ? 10 : 8);
    draw_icon(ImGui::GetWindowDrawList(), o.icon,
              ImVec2(std::floor(t.rect.centre().x), std::floor(middle - apart)), ui.px(12), ink);
    const Rect below{ImVec2(t.rect.min.x, middle), ImVec2(t.rect.max.x, middle + 2 * apart)};
    draw_text_centred(ui, below, Face::body_bold, ink, label);
  }
  draw_ring(ui, t);
}

}  // namespace

Hold hold_button(Ui& ui, std::string_view id, std::string_view label, const HoldOptions& o) {
  const About about{id, Kind::hold, label, o.lit ? "held" : "", o.disabled, o.moving, o.tip};
  Hold hold;
  hold.touch = touch(ui, about, ui.px(o.width, o.height));
  const Touch& t = hold.touch;
  if (t.held) ui.wake_in(1.0 / 30);  // a hold sends keep-alives in each frame
  hold.started = t.started;
  hold.held = t.held;
  // A button disabled while held is still active in ImGui; its release must not be lost.
  hold.ended = t.ended || (!t.enabled && (ImGui::IsItemActive() || ImGui::IsItemDeactivated()));
  if (!t.enabled && ImGui::IsItemActive()) ImGui::ClearActiveID();
  hold.pressed_at_s = t.pressed_at_s;
  hold.released_at_s = t.released_at_s;
  draw_hold(ui, t, label, o, t.held || o.lit);
  return hold;
}

}  // namespace hw::gui
