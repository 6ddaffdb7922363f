#include "gui/widgets/digits.h"

#include <array>
#include <cstdio>
#include <cstring>

#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

constexpr float unit_slot = 36;  // wider only for a unit that is a word

float slot_px(const Ui& ui, std::string_view unit) {
  if (unit.empty()) return 0;
  return std::max(ui.px(unit_slot), text_width(ui, Face::title, unit) + ui.px(8));
}

void draw_hatching(Ui& ui, const Rect& r) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(r.min, r.max, true);
  const ImU32 colour = with_alpha(ui[Tone::edge], 0.55f);
  for (float x = r.min.x - r.height(); x < r.max.x; x += ui.px(8))
    list->AddLine(ImVec2(x, r.max.y), ImVec2(x + r.height(), r.min.y), colour, ui.hair());
  list->PopClipRect();
}

}  // namespace

Touch digits(Ui& ui, std::string_view id, std::string_view label, std::string_view number,
             std::string_view unit, const DigitsOptions& o) {
  const float w = width_px(ui, o.width), h = ui.line(o.face);
  const Touch t = touch(ui, {id, Kind::button, label, number, {}, false, o.tip}, ImVec2(w, h));
  const float right = t.rect.max.x - slot_px(ui, unit), figures = text_width(ui, o.face, number);
  if (o.state == DigitsState::untrusted) {
    // The hatching is as high as the figures, from cap height to base line, and 3 beyond.
    const float cap = size_of(o.face).em * 0.727f * ui.scale * 0.5f + ui.px(3), y = t.rect.centre().y;
    draw_hatching(ui, {ImVec2(right - figures, std::floor(y - cap)), ImVec2(right, std::floor(y + cap))});
  }
  draw_text_right(ui, ImVec2(right, t.rect.min.y), o.face,
                  ui[o.state == DigitsState::good ? Tone::ink : Tone::ink3], number);
  // The unit shares the base line of the figures; the boxes of both faces are centred on their capitals.
  const float drop = (size_of(o.face).em - size_of(Face::title).em) * 0.727f * 0.5f * ui.scale;
  const float y = t.rect.centre().y - ui.line(Face::title) * 0.5f + drop;
  draw_text_right(ui, ImVec2(t.rect.max.x, std::floor(y + 0.5f)), Face::title, ui[Tone::ink2], unit);
  if (t.ring) draw_outline(ui, t.rect, ui[Tone::ink], 0, ui.px(2));
  return t;
}

float digits_width(const Ui& ui, Face face, std::string_view number, std::string_view unit) {
  return std::ceil(text_width(ui, face, number)) + std::ceil(slot_px(ui, unit));
}

Face digits_face(const Ui& ui, std::span<const std::string_view> numbers, std::string_view unit, Face wanted,
                 float width_px) {
  constexpr std::array faces{Face::digits48, Face::digits36, Face::digits32, Face::digits26};
  for (Face face : faces) {
    if (size_of(face).em > size_of(wanted).em) continue;
    bool fits = true;
    for (std::string_view number : numbers) fits &= digits_width(ui, face, number, unit) <= width_px;
    if (fits) return face;
  }
  return Face::digits26;
}

}  // namespace hw::gui
