#include "gui/widgets/tabs.h"

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "gui/widgets/text.h"

namespace hw::gui {

namespace {

constexpr std::string_view tab_badge_word = "EMULATED";

float margin_of(float width) { return width < 170 ? 12.0f : 16.0f; }

bool fits_in_words(const Ui& ui, const ControllerTab& tab, float width) {
  const float words = std::ceil(text_width(ui, Face::small, tab.state)) +
                      std::ceil(text_width(ui, Face::small_bold, tab_badge_word));
  return words + ui.px(margin_of(width) + 16 + 6 + 12) <= ui.px(width);
}

}  // namespace

Touch controller_tab(Ui& ui, std::string_view id, const ControllerTab& tab, float width) {
  const Touch t = touch(ui, {id, Kind::tab, tab.name, tab.state, {}, false, {}}, ui.px(width, 56));
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (tab.active)
    list->AddRectFilled(t.rect.min, t.rect.max, ui[Tone::panel]);
  else if (t.hovered || t.held)
    list->AddRectFilled(t.rect.min, t.rect.max, ui[Tone::raised]);
  if (tab.active)
    list->AddRectFilled(t.rect.min, ImVec2(t.rect.max.x, t.rect.min.y + ui.px(2)), ui[Tone::ink]);
  list->AddRectFilled(ImVec2(t.rect.max.x - ui.hair(), t.rect.min.y), t.rect.max, ui[Tone::line]);
  const float left = t.rect.min.x + ui.px(margin_of(width)), right = t.rect.max.x - ui.px(12);
  draw_text_line(ui, left, right, t.rect.min.y + ui.px(19), Face::body_bold,
                 ui[tab.active ? Tone::ink : Tone::ink2], tab.name);
  const float second = t.rect.min.y + ui.px(38);
  draw_icon(list, tab.icon, ImVec2(left + ui.px(6), second), ui.px(11), ui[tab.tone]);
  float end = right;
  if (tab.emulated) {
    if (fits_in_words(ui, tab, width)) {
      end -= std::ceil(text_width(ui, Face::small_bold, tab_badge_word));
      draw_text_line(ui, end, t.rect.max.x, second, Face::small_bold, ui[Tone::emu], tab_badge_word);
    } else {  // only its shape fits without cutting the state
      end -= ui.px(12);
      draw_icon(list, Icon::emulated, ImVec2(end + ui.px(6), second), ui.px(11), ui[Tone::emu]);
    }
  }
  draw_text_line(ui, left + ui.px(16), end - ui.px(4), second, Face::small, ui[tab.tone], tab.state);
  if (t.ring) draw_outline(ui, t.rect, ui[Tone::ink], 0, ui.px(2));
  return t;
}

int panel_tabs(Ui& ui, std::span<const PanelTab> tabs, int active) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const float h = ui.px(40);
  draw_across(ui, at.y + h - ui.hair(), at.y + h, ui[Tone::line]);
  const auto words_of = [&](int i) {
    return std::ceil(text_width(ui, i == active ? Face::body_bold : Face::body_medium,
                                tabs[static_cast<std::size_t>(i)].name));
  };
  // Tabs that do not fit move closer. If they still do not fit, the chosen tab is centred, so that all can be
  // reached.
  const float room = window->InnerRect.Max.x - at.x;
  float bare = 0;
  for (int i = 0; i < static_cast<int>(tabs.size()); ++i) bare += words_of(i);
  const float apart =
      std::clamp(std::floor((room - bare) / static_cast<float>(std::max<std::size_t>(1, tabs.size()))),
                 ui.px(8), ui.px(24));
  float all = 0, before = 0;
  for (int i = 0; i < static_cast<int>(tabs.size()); ++i) {
    if (i == active) before = all + (words_of(i) + apart) / 2;
    all += words_of(i) + apart;
  }
  const float past = std::clamp(before - room / 2, 0.0f, std::max(0.0f, all - room));
  int picked = -1;
  float x = at.x - std::floor(past);
  for (int i = 0; i < static_cast<int>(tabs.size()); ++i) {
    const PanelTab& tab = tabs[static_cast<std::size_t>(i)];
    const bool on = i == active;
    const float words = words_of(i);
    ImGui::SetCursorScreenPos(ImVec2(x, at.y));
    const Touch t = touch(ui, {tab.id, Kind::tab, tab.name, on ? "on" : "", tab.disabled, false, {}},
                          ImVec2(words + apart, h));
    const float text_left = t.rect.min.x + ui.px(4);
    draw_text_line(ui, text_left, t.rect.max.x, t.rect.centre().y, on ? Face::body_bold : Face::body_medium,
                   ui[!t.enabled        ? Tone::ink3
                      : on || t.hovered ? Tone::ink
                                        : Tone::ink2],
                   tab.name);
    if (on)
      window->DrawList->AddRectFilled(ImVec2(text_left, t.rect.max.y - ui.px(2)),
                                      ImVec2(text_left + words, t.rect.max.y), ui[Tone::ink]);
    if (t.ring)
      draw_outline(ui, {t.rect.min, ImVec2(text_left + words + ui.px(4), t.rect.max.y)}, ui[Tone::ink], 0,
                   ui.px(2));
    if (t.clicked && !on) picked = i;
    x = t.rect.max.x;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + h));
  return picked;
}

}  // namespace hw::gui
