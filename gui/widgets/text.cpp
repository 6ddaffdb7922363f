#include "gui/widgets/text.h"

#include <cfloat>

#include <imgui_internal.h>

namespace hw::gui {
namespace {

constexpr std::string_view ellipsis = "\xE2\x80\xA6";

ImVec2 snapped(ImVec2 at) { return ImVec2(std::floor(at.x), std::floor(at.y)); }

/// Top of the font's box within the line of the face, which is higher.
float box_top(const Ui& ui, Face face, float line_px) {
  return std::floor((line_px - ui.font(face)->FontSize) * 0.5f + 0.5f);
}

/// Keeps the tip of a field off the refusal of its number.
void keep_clear(const Ui& ui, ImVec2 at, ImVec2 end) {
  const ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 first = list->GetClipRectMin(), last = list->GetClipRectMax();
  const Rect seen{ImVec2(std::max(at.x, first.x), std::max(at.y, first.y)),
                  ImVec2(std::min(end.x, last.x), std::min(end.y, last.y))};
  if (seen.width() > 0 && seen.height() > 0) ui.registry.keep_clear(seen);
}

}  // namespace

float text_width(const Ui& ui, Face face, std::string_view s) {
  ImFont* font = ui.font(face);
  if (s.empty()) return 0;  // with a null address ImGui would search for the end
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, s.data(), s.data() + s.size()).x;
}

std::size_t text_fit(const Ui& ui, Face face, std::string_view s, float width_px) {
  ImFont* font = ui.font(face);
  const char* rest = s.data();
  if (s.empty()) return 0;
  font->CalcTextSizeA(font->FontSize, width_px, 0, s.data(), s.data() + s.size(), &rest);
  return static_cast<std::size_t>(rest - s.data());
}

void draw_text(const Ui& ui, ImVec2 at, Face face, ImU32 colour, std::string_view s) {
  if (s.empty()) return;
  ImFont* font = ui.font(face);
  const ImVec2 pos = snapped(ImVec2(at.x, at.y + box_top(ui, face, ui.line(face))));
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, pos, colour, s.data(), s.data() + s.size());
}

void draw_text_right(const Ui& ui, ImVec2 right, Face face, ImU32 colour, std::string_view s) {
  draw_text(ui, ImVec2(right.x - std::ceil(text_width(ui, face, s)), right.y), face, colour, s);
}

void draw_text_centred(const Ui& ui, const Rect& in, Face face, ImU32 colour, std::string_view s) {
  const float x = (in.min.x + in.max.x - text_width(ui, face, s)) * 0.5f;
  const float y = (in.min.y + in.max.y - ui.line(face)) * 0.5f;
  draw_text(ui, ImVec2(std::floor(x + 0.5f), std::floor(y + 0.5f)), face, colour, s);
}

void draw_text_line(const Ui& ui, float left, float right, float centre_y, Face face, ImU32 colour,
                    std::string_view s) {
  const ImVec2 at(left, std::floor(centre_y - ui.line(face) * 0.5f + 0.5f));
  // Only a tab is wider than its font is high, so a short text without tabs need not be measured.
  const bool is_short = left + static_cast<float>(s.size()) * ui.font(face)->FontSize <= right &&
                        s.find('\t') == std::string_view::npos;
  if (is_short || left + text_width(ui, face, s) <= right) return draw_text(ui, at, face, colour, s);
  const float half = ui.line(face) * 0.5f;
  if (ImGui::IsWindowHovered() &&
      ImGui::IsMouseHoveringRect(ImVec2(left, centre_y - half), ImVec2(right, centre_y + half)))
    ui.note_cut(s);
  const std::size_t fits = text_fit(ui, face, s, right - left - text_width(ui, face, ellipsis));
  draw_text(ui, at, face, colour, s.substr(0, fits));
  draw_text(ui, ImVec2(left + text_width(ui, face, s.substr(0, fits)), at.y), face, colour, ellipsis);
}

void draw_text_in_two_lines(const Ui& ui, float left, float right, float centre_y, Face face, ImU32 colour,
                            std::string_view s) {
  const float room = right - left;
  if (s.empty() || text_width(ui, face, s) <= room)
    return draw_text_line(ui, left, right, centre_y, face, colour, s);
  const char* end = ui.font(Face::small)->CalcWordWrapPositionA(1.0f, s.data(), s.data() + s.size(), room);
  const std::string_view first(s.data(), static_cast<std::size_t>(end - s.data()));
  std::string_view second = s.substr(first.size());
  while (second.starts_with(' ')) second.remove_prefix(1);
  const float half = second.empty() ? 0 : ui.line(Face::small) * 0.5f;
  draw_text_line(ui, left, right, centre_y - half, Face::small, colour, first);
  if (!second.empty()) draw_text_line(ui, left, right, centre_y + half, Face::small, colour, second);
}

void draw_text_in_lines(const Ui& ui, const Rect& in, Face face, ImU32 colour, std::string_view s,
                        int lines) {
  std::string_view rest = s;
  for (int n = 0; n < lines && !rest.empty(); ++n) {
    std::string_view line = rest;
    if (n + 1 < lines) {
      const char* end =
          ui.font(face)->CalcWordWrapPositionA(1.0f, rest.data(), rest.data() + rest.size(), in.width());
      line = rest.substr(0, std::max<std::size_t>(1, static_cast<std::size_t>(end - rest.data())));
    }
    const float middle = in.min.y + ui.line(face) * (static_cast<float>(n) + 0.5f);
    draw_text_line(ui, in.min.x, in.max.x, middle, face, colour, line);
    rest.remove_prefix(line.size());
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    const bool cut = n + 1 == lines && text_width(ui, face, line) > in.width();
    if (cut && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(in.min, in.max)) ui.note_cut(s);
  }
}

void text(Ui& ui, Face face, Tone tone, std::string_view s) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(std::ceil(text_width(ui, face, s)), ui.line(face));
  draw_text(ui, at, face, ui[tone], s);
  if (tone == Tone::fault) keep_clear(ui, at, ImVec2(at.x + size.x, at.y + size.y));
  ImGui::Dummy(size);
}

float wrapped_height(const Ui& ui, Face face, std::string_view s, float width_px) {
  ImFont* font = ui.font(face);
  float lines = 0;
  const char *at = s.data(), *end = s.data() + s.size();
  while (at < end) {
    const char* next = font->CalcWordWrapPositionA(1.0f, at, end, width_px);
    if (next == at) ++next;
    const char* newline = static_cast<const char*>(memchr(at, '\n', static_cast<std::size_t>(next - at)));
    at = newline ? newline + 1 : next;
    while (!newline && at < end && *at == ' ') ++at;
    ++lines;
  }
  return lines * ui.line(face);
}

void wrapped(Ui& ui, Face face, Tone tone, std::string_view s, float width) {
  ImFont* font = ui.font(face);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float limit = width_px(ui, width);
  float y = start.y;
  const char *at = s.data(), *end = s.data() + s.size();
  while (at < end) {
    const char* next = font->CalcWordWrapPositionA(1.0f, at, end, limit);
    if (next == at) ++next;  // not even one character fits
    const char* newline = static_cast<const char*>(memchr(at, '\n', static_cast<std::size_t>(next - at)));
    const char* stop = newline ? newline : next;
    draw_text(ui, ImVec2(start.x, y), face, ui[tone], {at, static_cast<std::size_t>(stop - at)});
    y += ui.line(face);
    at = newline ? newline + 1 : next;
    while (!newline && at < end && *at == ' ') ++at;
  }
  if (tone == Tone::fault) keep_clear(ui, start, ImVec2(start.x + limit, y));
  ImGui::Dummy(ImVec2(limit, y - start.y));
}

void named_text(Ui& ui, std::string_view id, Face face, Tone tone, std::string_view s) {
  text(ui, face, tone, s);
  Widget w;
  w.id = id;
  w.label = w.value = s;
  w.kind = Kind::text;
  w.rect = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
  const ImRect& clip = ImGui::GetCurrentWindow()->ClipRect;
  w.clip = {clip.Min, clip.Max};
  ui.registry.add(w);
}

float width_px(const Ui& ui, float width) {
  return width < 0 ? std::max(1.0f, std::floor(ImGui::GetContentRegionAvail().x)) : ui.px(width);
}

void gap(Ui& ui, float height) {
  ImGui::SetCursorScreenPos(
      ImVec2(ImGui::GetCursorScreenPos().x, ImGui::GetCursorScreenPos().y + ui.px(height)));
}

Rect draw_across(const Ui& ui, float top, float bottom, ImU32 colour, ImU32 bar) {
  // A window's own clip rectangle excludes half of its padding.
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  ImRect clip = window->InnerRect;
  clip.ClipWith(window->OuterRectClipped);
  const Rect r{ImVec2(window->InnerRect.Min.x, top), ImVec2(window->InnerRect.Max.x, bottom)};
  window->DrawList->PushClipRect(clip.Min, clip.Max, false);
  if (colour) window->DrawList->AddRectFilled(r.min, r.max, colour);
  if (bar) window->DrawList->AddRectFilled(r.min, ImVec2(r.min.x + ui.px(3), bottom), bar);
  window->DrawList->PopClipRect();
  return r;
}

void group_line(Ui& ui, float space) {
  gap(ui, space);
  const float y = std::floor(ImGui::GetCursorScreenPos().y);
  draw_across(ui, y, y + ui.hair(), ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, y + ui.hair()));
  gap(ui, space);
}

void section_title(Ui& ui, std::string_view title, std::string_view caption, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float h = ui.px(height), width = ImGui::GetContentRegionAvail().x;
  draw_text_line(ui, at.x, at.x + width, at.y + h * 0.5f, Face::body_bold, ui[Tone::ink], title);
  if (!caption.empty()) {  // right-aligned, cut before the title
    const float first = at.x + std::ceil(text_width(ui, Face::body_bold, title)) + ui.px(8);
    const float wanted = at.x + width - std::ceil(text_width(ui, Face::small, caption));
    draw_text_line(ui, std::max(first, wanted), at.x + width + 1, at.y + h * 0.5f + 1, Face::small,
                   ui[Tone::ink2], caption);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + h));
}

void key_value(Ui& ui, std::string_view id, std::string_view key, std::string_view value, Tone tone) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, h = ui.px(24);
  // A long value is cut, so that the key stays whole.
  const float key_width = std::min(std::ceil(text_width(ui, Face::body, key)), std::floor(width * 0.6f));
  const float value_width =
      std::min(std::ceil(text_width(ui, Face::body, value)), width - key_width - ui.px(8));
  draw_text_line(ui, at.x, at.x + width - value_width - ui.px(8), at.y + h * 0.5f, Face::body, ui[Tone::ink2],
                 key);
  draw_text_line(ui, at.x + width - value_width, at.x + width + 1, at.y + h * 0.5f, Face::body, ui[tone],
                 value);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + h));
  if (id.empty()) return;
  Widget w;
  w.id = id;
  w.label = key;
  w.value = value;
  w.kind = Kind::text;
  w.rect = {at, ImVec2(at.x + width, at.y + h)};
  const ImRect& clip = ImGui::GetCurrentWindow()->ClipRect;
  w.clip = {clip.Min, clip.Max};
  ui.registry.add(w);
}

namespace {

/// The area that a rectangle covers of widgets that must stay legible. A Stop counts most.
float covered(const Ui& ui, ImVec2 at, ImVec2 size) {
  constexpr float of_a_stop = 100;
  float area = 0;
  const auto add = [&](const Rect& r, float weight) {
    const float width = std::min(r.max.x, at.x + size.x) - std::max(r.min.x, at.x);
    const float height = std::min(r.max.y, at.y + size.y) - std::max(r.min.y, at.y);
    if (width > 0 && height > 0) area += weight * width * height;
  };
  for (const Rect& r : ui.registry.kept_clear()) add(r, 1);
  for (const Widget& w : ui.registry.widgets()) {
    if ((!w.stops && !w.card) || w.layer < ui.registry.top_layer()) continue;  // under a dialog
    const Rect seen{ImVec2(std::max(w.rect.min.x, w.clip.min.x), std::max(w.rect.min.y, w.clip.min.y)),
                    ImVec2(std::min(w.rect.max.x, w.clip.max.x), std::min(w.rect.max.y, w.clip.max.y))};
    add(seen, w.stops ? of_a_stop : 1);
  }
  return area;
}

/// The tooltip's place is below `of`, above it or left of it: the place that covers least of the areas kept
/// clear.
ImVec2 tooltip_place(const Ui& ui, const Rect& of, ImVec2 size) {
  const float apart = ui.px(6), over = of.min.y - apart - size.y, under = of.max.y + apart;
  const float left = of.min.x - ui.px(24) - size.x, middle = std::floor(of.centre().y - size.y / 2);
  const ImVec2 places[] = {{of.min.x, under}, {of.min.x, over}, {left, under}, {left, over}, {left, middle}};
  const auto within = [&](ImVec2 at) {
    return ImVec2(std::clamp(at.x, 0.0f, std::max(0.0f, ui.size_px.x - size.x)), at.y);
  };
  ImVec2 best = within(places[under + size.y > ui.size_px.y ? 1 : 0]);
  float least = covered(ui, best, size);
  for (const ImVec2 place : places) {
    const ImVec2 at = within(place);
    if (least == 0) break;
    if (at.y < 0 || at.y + size.y > ui.size_px.y || at.x > place.x) continue;
    if (const float covers = covered(ui, at, size); covers < least) best = at, least = covers;
  }
  return best;
}

}  // namespace

void tooltip(Ui& ui, std::string_view sentence, const Rect* beside) {
  if (sentence.empty()) return;
  ui.note_tip();
  const float limit = ui.px(320);
  const float width = std::min(limit, std::ceil(text_width(ui, Face::small, sentence)) + 1);
  const float height = wrapped_height(ui, Face::small, sentence, width);
  const ImVec2 pad = ui.px(8, 6);
  const ImVec2 size(width + 2 * pad.x, height + 2 * pad.y);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Rect of =
      beside ? *beside : Rect{ImVec2(mouse.x + ui.px(12), mouse.y), ImVec2(mouse.x, mouse.y + ui.px(12))};
  ImGui::SetNextWindowPos(snapped(tooltip_place(ui, of, size)));
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, pad);
  ImGui::PushStyleColor(ImGuiCol_PopupBg, ui[Tone::raised]);
  ImGui::BeginTooltip();
  wrapped(ui, Face::small, Tone::ink, sentence, width / ui.scale);
  ImGui::EndTooltip();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace hw::gui
