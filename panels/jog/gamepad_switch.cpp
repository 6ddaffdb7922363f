#include "panels/jog/gamepad_switch.h"

#include <cmath>

#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"

namespace hw::panels {

using namespace gui;
namespace {

/// Draws a gamepad: its body, the cross at the left and two buttons at the right.
void draw_sign(const Ui& ui, ImVec2 centre, ImU32 colour, ImU32 ground) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 c(std::floor(centre.x), std::floor(centre.y));
  const auto bar = [&](float x, float y, float width, float height) {
    const ImVec2 from(c.x + ui.px(x), c.y + ui.px(y));
    list->AddRectFilled(from, ImVec2(from.x + ui.px(width), from.y + ui.px(height)), ground);
  };
  list->AddRectFilled(ImVec2(c.x - ui.px(11), c.y - ui.px(6)), ImVec2(c.x + ui.px(11), c.y + ui.px(6)),
                      colour, ui.px(6));
  bar(-8, -1, 6, 2);
  bar(-6, -3, 2, 6);
  bar(3, 0, 2, 2);
  bar(6, -2, 2, 2);
}

}  // namespace

void draw_gamepad_switch(Frame& f, ImVec2 at, float side) {
  Ui& ui = f.ui;
  Gamepad& pad = ui.gamepad;
  if (!pad.present()) return;
  const bool armed = pad.armed();
  const Path value("{}, {}", armed ? "armed" : "off", pad.name());
  const Path tip(
      "{}. {}", pad.name(),
      armed ? "Disarms it."
            : "Arms the gamepad: while LB is held, a stick jogs. B stops. Leaving the window disarms it.");
  ImGui::SetCursorScreenPos(at);
  const Touch t =
      touch(ui, {"jog/gamepad", Kind::toggle, "Gamepad", value, {}, false, tip}, ui.px(side, side));
  const Tone ground = armed || t.held ? Tone::sel : t.hovered ? Tone::hover : Tone::raised;
  draw_fill(ui, t.rect, ui[ground]);
  if (armed) draw_outline(ui, t.rect, ui[Tone::motion]);
  const ImVec2 middle = t.rect.centre();
  draw_sign(ui, ImVec2(middle.x, middle.y - ui.px(8)), ui[armed ? Tone::motion : Tone::ink2], ui[ground]);
  draw_text_centred(ui, {ImVec2(t.rect.min.x, middle.y), ImVec2(t.rect.max.x, middle.y + ui.px(18))},
                    armed ? Face::small_bold : Face::small, ui[armed ? Tone::motion : Tone::ink2],
                    armed ? "Armed" : "Pad");
  draw_ring(ui, t);
  if (t.clicked && armed) pad.disarm(ui.now_s);
  if (t.clicked && !armed) pad.arm(ui.now_s);
}

Path gamepad_hint(const Frame& f) {
  return Path("{}: hold LB, then push a stick. B stops.", f.ui.gamepad.name().substr(0, 40));
}

}  // namespace hw::panels
