#include "gui/widgets/button.h"

#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

constexpr float icon_size = 12, icon_gap = 8, side = 12;

struct Paint {
  ImU32 fill, outline, ink, hint;
};

Paint paint_disabled(const Ui& ui, ButtonStyle style) {
  const bool framed = style != ButtonStyle::quiet && style != ButtonStyle::segment;
  return {0, framed ? ui[Tone::line] : 0, ui[Tone::ink3], ui[Tone::ink3]};
}

Paint paint_of(const Ui& ui, const Touch& t, const ButtonOptions& o) {
  if (!t.enabled) return paint_disabled(ui, o.style);
  if (o.moving && t.held) return {ui[Tone::motion], 0, ui[Tone::on_motion], ui[Tone::on_motion]};
  const ImU32 rest = t.held || o.on ? ui[Tone::sel] : t.hovered ? ui[Tone::hover] : ui[Tone::raised];
  const ImU32 pressed_edge = t.held || o.on ? ui[Tone::edge] : 0;
  const ImU32 bare = t.held || o.on ? ui[Tone::sel] : t.hovered ? ui[Tone::hover] : 0;
  switch (o.style) {
    case ButtonStyle::primary:
      return {t.hovered || t.held ? ui[Tone::ink2] : ui[Tone::ink], 0, ui[Tone::panel], ui[Tone::panel]};
    case ButtonStyle::quiet: return {bare, pressed_edge, ui[Tone::ink], ui[Tone::ink3]};
    case ButtonStyle::outlined: return {bare, ui[Tone::edge], ui[Tone::ink], ui[Tone::ink3]};
    case ButtonStyle::danger: return {bare, ui[Tone::fault], ui[Tone::fault], ui[Tone::fault]};
    case ButtonStyle::segment:
      return {bare, pressed_edge, o.on ? ui[Tone::ink] : ui[Tone::ink2], ui[Tone::ink3]};
    case ButtonStyle::normal: break;
  }
  return {rest, pressed_edge, ui[Tone::ink], ui[Tone::ink3]};
}

Face face_of(const ButtonOptions& o) { return o.on ? Face::body_bold : Face::body_medium; }

/// Width of the key hint: its words, and the Enter sign for '\n'.
float hint_width(const Ui& ui, std::string_view keys) {
  if (keys.empty()) return 0;
  const bool enter = keys.back() == '\n';
  return text_width(ui, Face::small, enter ? keys.substr(0, keys.size() - 1) : keys) +
         (enter ? ui.px(12) : 0);
}
void draw_hint(const Ui& ui, ImVec2 at, std::string_view keys, ImU32 colour) {
  const bool enter = keys.back() == '\n';
  const std::string_view words = enter ? keys.substr(0, keys.size() - 1) : keys;
  draw_text(ui, at, Face::small, colour, words);
  if (enter)
    draw_icon(ImGui::GetWindowDrawList(), Icon::enter,
              ImVec2(at.x + text_width(ui, Face::small, words) + ui.px(6), at.y + ui.px(8)), ui.px(12),
              colour);
}

float content_width(const Ui& ui, std::string_view label, const ButtonOptions& o) {
  float w = label.empty() ? 0 : std::ceil(text_width(ui, face_of(o), label));
  const float gap = label.empty() ? 0 : ui.px(icon_gap);
  if (o.icon != Icon::none) w += ui.px(icon_size) + gap;
  if (o.icon_after != Icon::none) w += ui.px(icon_size) + gap;
  if (!o.keys.empty()) w += std::ceil(hint_width(ui, o.keys)) + ui.px(8);
  return w;
}

void draw_content(const Ui& ui, const Rect& r, std::string_view label, const ButtonOptions& o,
                  const Paint& paint) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float middle = std::floor((r.min.y + r.max.y) * 0.5f);
  const float gap = label.empty() ? 0 : ui.px(icon_gap);
  float x = std::floor(r.min.x + std::max(ui.px(4), (r.width() - content_width(ui, label, o)) * 0.5f));
  if (o.icon != Icon::none) {
    const bool own_tone = o.icon_tone != Tone::ink && o.disabled.empty();
    draw_icon(list, o.icon, ImVec2(x + ui.px(icon_size) * 0.5f, middle), ui.px(icon_size),
              own_tone ? ui[o.icon_tone] : paint.ink);
    x += ui.px(icon_size) + gap;
  }
  draw_text_line(ui, x, r.max.x, middle, face_of(o), paint.ink, label);
  x += std::ceil(text_width(ui, face_of(o), label));
  if (!o.keys.empty()) {
    draw_hint(ui, ImVec2(x + ui.px(8), middle - ui.px(8)), o.keys, paint.hint);
    x += hint_width(ui, o.keys) + ui.px(8);
  }
  if (o.icon_after != Icon::none)
    draw_icon(list, o.icon_after, ImVec2(x + gap + ui.px(icon_size) * 0.5f, middle), ui.px(icon_size),
              paint.ink);
}

}  // namespace

float button_width(const Ui& ui, std::string_view label, const ButtonOptions& o) {
  if (o.wordless) label = {};
  const float w = std::ceil(content_width(ui, label, o) / ui.scale) + 2 * side;
  return label.empty() ? std::max(32.0f, w) : std::max(w, 32.0f);
}

Touch button(Ui& ui, std::string_view id, std::string_view label, const ButtonOptions& o) {
  const float w = o.width == 0 ? ui.px(button_width(ui, label, o)) : width_px(ui, o.width);
  const About about{id, Kind::button, label, o.on ? "on" : "", o.disabled, o.moving, o.tip, false, o.stops};
  const Touch t = touch(ui, about, ImVec2(w, ui.px(o.height)));
  const Paint paint = paint_of(ui, t, o);
  if (paint.fill) draw_fill(ui, t.rect, paint.fill);
  if (paint.outline) draw_outline(ui, t.rect, paint.outline);
  if (o.moving && !(t.enabled && t.held))
    draw_motion_edge(ui, t.rect, ui[t.enabled ? Tone::motion : Tone::line]);
  draw_content(ui, t.rect, o.wordless ? std::string_view() : label, o, paint);
  draw_ring(ui, t);
  return t;
}

bool link(Ui& ui, std::string_view id, std::string_view label, std::string_view disabled) {
  const ImVec2 size(std::ceil(text_width(ui, Face::small, label)), ui.line(Face::small));
  const Touch t = touch(ui, {id, Kind::link, label, {}, disabled, false, {}}, size);
  const ImU32 colour = ui[!t.enabled ? Tone::ink3 : t.hovered ? Tone::ink : Tone::ink2];
  draw_text(ui, t.rect.min, Face::small, colour, label);
  const float y = t.rect.max.y - ui.px(1);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(t.rect.min.x, y), ImVec2(t.rect.max.x, y + ui.hair()),
                                            colour);
  draw_ring(ui, t);
  return t.clicked;
}

Touch stop_button(Ui& ui, ImVec2 size, std::string_view second) {
  const Touch t = touch(ui, {"stop_all", Kind::button, "STOP ALL", second, {}, false, {}, true, true}, size);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 fill_colour = t.held ? ui[Tone::on_stop] : ui[Tone::stop];
  const ImU32 ink = t.held ? ui[Tone::stop] : ui[Tone::on_stop];
  list->AddRectFilled(t.rect.min, t.rect.max, fill_colour);
  if (t.hovered && !t.held) draw_outline(ui, t.rect, ui[Tone::on_stop], 0, ui.px(2));
  const float words = std::ceil(text_width(ui, Face::stop, "STOP ALL")), key = ui.px(32), between = ui.px(12);
  const float y = second.empty() ? std::floor(t.rect.centre().y) : t.rect.min.y + ui.px(18);
  const float x = std::floor(t.rect.centre().x - (words + between + key) * 0.5f);
  draw_text_line(ui, x, t.rect.max.x, y, Face::stop, ink, "STOP ALL");
  const Rect frame{ImVec2(x + words + between, y - ui.px(9)),
                   ImVec2(x + words + between + key, y + ui.px(9))};
  draw_outline(ui, frame, ink);
  draw_text_centred(ui, frame, Face::small_bold, ink, "esc");
  if (!second.empty()) {
    const Rect line{ImVec2(t.rect.min.x, t.rect.max.y - ui.px(24)),
                    ImVec2(t.rect.max.x, t.rect.max.y - ui.px(6))};
    if (text_width(ui, Face::small_bold, second) <= line.width() - ui.px(16))
      draw_text_centred(ui, line, Face::small_bold, ink, second);
    else
      draw_text_line(ui, line.min.x + ui.px(8), line.max.x - ui.px(8), line.centre().y, Face::small_bold, ink,
                     second);
  }
  if (t.ring) {
    const Rect in{ImVec2(t.rect.min.x + ui.px(2), t.rect.min.y + ui.px(2)),
                  ImVec2(t.rect.max.x - ui.px(2), t.rect.max.y - ui.px(2))};
    draw_outline(ui, in, ui[Tone::on_stop], 0, ui.px(2));
  }
  return t;
}

}  // namespace hw::gui
