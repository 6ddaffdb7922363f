#include "gui/widgets/lamp.h"

#include <algorithm>
#include <cmath>

#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

void draw_dashed_shape(Ui& ui, ImVec2 c, float size, LampShape shape, ImU32 colour) {
  const float r = std::floor(size * 0.5f);
  if (shape == LampShape::square)
    return draw_dashed_outline(ui, {ImVec2(c.x - r, c.y - r), ImVec2(c.x + r, c.y + r)}, colour);
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (int dash = 0; dash < 8; ++dash) {
    const float a = static_cast<float>(dash) * 0.7853982f;
    list->PathArcTo(c, r - ui.hair() * 0.5f, a, a + 0.45f, 4);
    list->PathStroke(colour, ImDrawFlags_None, ui.hair() * 1.25f);
  }
}

void draw_lit(Ui& ui, ImVec2 c, float size, LampShape shape, Tone tone) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float r = std::floor(size * 0.5f);
  if (shape == LampShape::square) {
    const Rect box{ImVec2(c.x - r, c.y - r), ImVec2(c.x + r, c.y + r)};
    list->AddRectFilled(box.min, box.max, ui[tone]);
    if (!ui.theme.dark) draw_outline(ui, box, ui[Tone::ink2], 0);
    return;
  }
  list->AddCircleFilled(c, r, ui[tone]);
  list->AddCircle(c, r - ui.hair() * 0.5f, ui[Tone::ink2], 0, ui.hair());
}

std::string_view word_of(const ToggleOptions& o) {
  if (!o.word.empty()) return o.word;
  switch (o.state) {
    case ToggleState::off: return "off";
    case ToggleState::on: return "on";
    case ToggleState::sending: return "sending";
    case ToggleState::refused: return "refused";
    case ToggleState::stale: return "?";
  }
  return {};
}

/// A narrow toggle has no word. The spaces beside its lamp and name shrink to fit.
struct NarrowSpacing {
  float left = 0, apart = 0;
};
NarrowSpacing spacing_in(const Ui& ui, float width, std::string_view name) {
  const float free = width - ui.px(12) - text_width(ui, Face::body_bold, name);
  return {std::clamp(free / 4, ui.px(4), ui.px(8)), std::clamp(free / 4, ui.px(2), ui.px(8))};
}

void draw_toggle_frame(Ui& ui, const Touch& t, const ToggleOptions& o) {
  if (!t.enabled) return draw_outline(ui, t.rect, ui[Tone::line]);
  if (o.state == ToggleState::stale) return draw_dashed_outline(ui, t.rect, ui[Tone::edge]);
  const bool on = o.state == ToggleState::on;
  draw_fill(ui, t.rect, ui[on || t.held ? Tone::sel : t.hovered ? Tone::hover : Tone::raised]);
  if (o.state == ToggleState::refused)
    draw_outline(ui, t.rect, ui[Tone::fault]);
  else if (on || t.held)
    draw_outline(ui, t.rect, ui[Tone::edge]);
}

}  // namespace

void draw_lamp(Ui& ui, ImVec2 c, float size, LampShape shape, LampState state, Tone tone) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float px = ui.px(size);
  const Icon empty = shape == LampShape::square ? Icon::square : Icon::ring;
  switch (state) {
    case LampState::on: return draw_lit(ui, c, px, shape, tone);
    case LampState::hit: return draw_lit(ui, c, px, shape, Tone::lamp_warn);
    case LampState::unknown: return draw_dashed_shape(ui, c, px, shape, ui[Tone::edge]);
    case LampState::armed: return draw_icon(list, Icon::ring_dot, c, px, ui[Tone::ink2]);
    case LampState::off:
    case LampState::disabled: return draw_icon(list, empty, c, px, ui[Tone::edge]);
  }
}

void lamp(Ui& ui, std::string_view id, std::string_view name, const LampOptions& o) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float h = ui.px(o.height), middle = at.y + std::floor(h * 0.5f);
  const bool hit = o.state == LampState::hit, on = o.state == LampState::on;
  const Face name_face = hit || on ? Face::body_bold : Face::body;
  const Face word_face = hit || on ? Face::small_bold : Face::small;
  const float name_width = std::ceil(text_width(ui, name_face, name));
  const float natural = ui.px(20) + name_width + ui.px(8) + std::ceil(text_width(ui, word_face, o.word));
  const float w = o.width == 0 ? natural : width_px(ui, o.width);
  draw_lamp(ui, ImVec2(at.x + ui.px(6), middle), 12, o.shape, o.state);
  const bool dim = o.state == LampState::unknown || o.state == LampState::disabled;
  draw_text_line(ui, at.x + ui.px(20), at.x + w, middle, name_face, ui[dim ? Tone::ink3 : Tone::ink], name);
  if (o.word_shown)
    draw_text_line(ui, at.x + ui.px(28) + name_width, at.x + w + 1, middle, word_face,
                   ui[hit  ? Tone::warn
                      : on ? Tone::ink
                           : Tone::ink3],
                   o.word);
  ImGui::Dummy(ImVec2(w, h));
  const std::string_view value = !o.word.empty()             ? o.word
                                 : on || hit                 ? "on"
                                 : o.state == LampState::off ? "off"
                                                             : "?";
  show(ui, {id, Kind::lamp, name, value, {}, false, o.tip}, {at, ImVec2(at.x + w, at.y + h)});
}

Touch toggle_lamp(Ui& ui, std::string_view id, std::string_view name, const ToggleOptions& o) {
  const std::string_view word = word_of(o);
  const Touch t = touch(ui, {id, Kind::toggle, name, word, o.disabled, false, o.tip},
                        ImVec2(width_px(ui, o.width), ui.px(32)));
  draw_toggle_frame(ui, t, o);
  const float middle = std::floor(t.rect.centre().y);
  const NarrowSpacing narrow = spacing_in(ui, t.rect.width(), o.narrow ? name : std::string_view());
  const float shape_middle = o.narrow ? narrow.left + ui.px(6) : ui.px(14);
  const ImVec2 shape_at(std::floor(t.rect.min.x + shape_middle), middle);
  const bool on = o.state == ToggleState::on, refused = o.state == ToggleState::refused;
  const bool dim = !t.enabled || o.state == ToggleState::stale;
  if (refused)
    draw_icon(ImGui::GetWindowDrawList(), Icon::diamond_solid, shape_at, ui.px(12), ui[Tone::fault]);
  else
    draw_lamp(ui, shape_at, 12, LampShape::round,
              o.state == ToggleState::stale ? LampState::unknown
              : on                          ? LampState::on
                                            : LampState::off);
  const Face word_face = on ? Face::small_bold : Face::small;
  const float word_left =
      t.rect.max.x - (o.narrow ? 0 : ui.px(8) + std::ceil(text_width(ui, word_face, word)));
  const float name_left = o.narrow ? narrow.left + ui.px(12) + narrow.apart : ui.px(26);
  draw_text_line(ui, std::floor(t.rect.min.x + name_left), word_left - ui.px(o.narrow ? 1 : 4), middle,
                 o.narrow && on ? Face::body_bold : Face::body, ui[dim ? Tone::ink3 : Tone::ink], name);
  if (!o.narrow)
    draw_text_line(ui, word_left, t.rect.max.x, middle, word_face,
                   ui[refused      ? Tone::fault
                      : on && !dim ? Tone::ink
                                   : Tone::ink3],
                   word);
  draw_ring(ui, t);
  return t;
}

Touch toggle_cell(Ui& ui, std::string_view id, std::string_view name, bool on, float width,
                  std::string_view tip) {
  Touch t = touch(ui, {id, Kind::toggle, name, on ? "on" : "off", {}, false, tip}, ui.px(width, 32));
  const float apart = ui.px(2);
  t.rect = {ImVec2(t.rect.min.x + apart, t.rect.min.y + apart),
            ImVec2(t.rect.max.x - apart, t.rect.max.y - apart)};
  ToggleOptions o;
  o.state = on ? ToggleState::on : ToggleState::off;
  draw_toggle_frame(ui, t, o);
  draw_lamp(ui, ImVec2(std::floor(t.rect.centre().x), std::floor(t.rect.centre().y)), 12, LampShape::round,
            on ? LampState::on : LampState::off);
  draw_ring(ui, t);
  return t;
}

}  // namespace hw::gui
