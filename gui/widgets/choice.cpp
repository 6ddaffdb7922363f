#include "gui/widgets/choice.h"

#define GLFW_INCLUDE_NONE
#include <array>
#include <cstring>

#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/region.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

/// The id `id/<name>`, built on the stack.
class ChildId {
 public:
  ChildId(std::string_view id, std::string_view name) {
    put(id);
    put("/");
    put(name);
  }
  operator std::string_view() const { return {bytes_.data(), size_}; }  // NOLINT

 private:
  void put(std::string_view s) {
    const std::size_t n = std::min(s.size(), bytes_.size() - size_);
    std::memcpy(bytes_.data() + size_, s.data(), n);
    size_ += n;
  }
  std::array<char, 160> bytes_{};
  std::size_t size_ = 0;
};

float widest(const Ui& ui, std::span<const std::string_view> names) {
  float w = 0;
  for (std::string_view name : names) w = std::max(w, std::ceil(text_width(ui, Face::body_bold, name)));
  return w;
}

/// Draws the rows of an open list. Returns the index chosen in this frame, or -1.
int draw_list(Ui& ui, std::string_view id, std::span<const std::string_view> names, int chosen, float width) {
  ui.take_arrows();
  int picked = -1;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const std::string_view name = names[static_cast<std::size_t>(i)];
    const Touch t = touch(ui, {ChildId(id, name), Kind::row, name, i == chosen ? "on" : "", {}, false, {}},
                          ImVec2(width, ui.px(32)));
    if (i == chosen || t.hovered || t.ring)
      ImGui::GetWindowDrawList()->AddRectFilled(t.rect.min, t.rect.max,
                                                ui[t.hovered ? Tone::hover : Tone::sel]);
    if (i == chosen)
      ImGui::GetWindowDrawList()->AddRectFilled(t.rect.min, ImVec2(t.rect.min.x + ui.px(3), t.rect.max.y),
                                                ui[Tone::ink]);
    draw_text_line(ui, t.rect.min.x + ui.px(12), t.rect.max.x, t.rect.centre().y,
                   i == chosen ? Face::body_bold : Face::body, ui[Tone::ink], name);
    if (t.ring) draw_outline(ui, t.rect, ui[Tone::ink], 0, ui.px(2));
    if (t.clicked) picked = i;
  }
  const int step = ImGui::IsKeyPressed(GLFW_KEY_DOWN) - ImGui::IsKeyPressed(GLFW_KEY_UP);
  if (step != 0 && !names.empty()) {
    int at = chosen;
    for (int i = 0; i < static_cast<int>(names.size()); ++i)
      if (ui.focus.is(ChildId(id, names[static_cast<std::size_t>(i)]))) at = i;
    at = std::clamp(at + step, 0, static_cast<int>(names.size()) - 1);
    ui.focus.move_to(ChildId(id, names[static_cast<std::size_t>(at)]));
  }
  return picked;
}

/// The list below a clicked button. It stays open until a choice or Esc.
int list_under(Ui& ui, std::string_view id, const Touch& t, std::span<const std::string_view> names,
               int chosen) {
  ImGui::PushID(id.data(), id.data() + id.size());
  if (t.clicked) ImGui::OpenPopup("list");
  if (!ImGui::IsPopupOpen("list")) {  // the names need not be measured
    ImGui::PopID();
    return -1;
  }
  const float width = std::max(t.rect.width(), widest(ui, names) + ui.px(28));
  const float height = ui.px(32) * static_cast<float>(names.size()) + 2 * ui.hair();
  const Rect place = place_list(ui, t.rect, width, height);
  ImGui::SetNextWindowPos(place.min);
  ImGui::SetNextWindowSize(ImVec2(width, place.height()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.hair(), ui.hair()));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  int picked = -1;
  if (ImGui::BeginPopup("list", ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    picked = draw_list(ui, id, names, chosen, width - 2 * ui.hair());
    if (picked >= 0 || ui.cancelled()) {
      ImGui::CloseCurrentPopup();
      ui.focus.set(id);
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  ImGui::PopID();
  return picked;
}

}  // namespace

Rect place_list(const Ui& ui, const Rect& opener, float width, float height) {
  const float top = ui.px(top_bar_height), h = std::min(height, ui.size_px.y - top);
  const float below = opener.max.y + ui.px(2), above = opener.min.y - ui.px(2) - h;
  const float y = below + h <= ui.size_px.y ? below : above >= top ? above : ui.size_px.y - h;
  const float x = std::clamp(opener.min.x, 0.0f, std::max(0.0f, ui.size_px.x - width - ui.px(4)));
  return {ImVec2(x, y), ImVec2(x + width, y + h)};
}

int segment(Ui& ui, std::string_view id, std::span<const std::string_view> names, int chosen,
            const SegmentOptions& o) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float h = ui.px(o.height);
  float total = 0;
  const auto cell = [&](std::string_view name) {
    return std::max(ui.px(o.cell_width), std::ceil(text_width(ui, Face::body_bold, name)) + ui.px(20));
  };
  for (std::string_view name : names) total += cell(name);
  const Rect all{at, ImVec2(at.x + total, at.y + h)};
  draw_fill(ui, all, ui[Tone::well]);
  draw_outline(ui, all, ui[Tone::line]);
  int picked = -1;
  float x = at.x;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const std::string_view name = names[static_cast<std::size_t>(i)];
    ImGui::SetCursorScreenPos(ImVec2(x, at.y));
    const Touch t =
        touch(ui, {ChildId(id, name), Kind::choice, name, i == chosen ? "on" : "off", o.disabled, false, {}},
              ImVec2(cell(name), h));
    if (i == chosen || t.hovered) draw_fill(ui, t.rect, ui[i == chosen ? Tone::sel : Tone::hover]);
    if (i == chosen) draw_outline(ui, t.rect, ui[Tone::edge]);
    draw_text_centred(ui, t.rect, i == chosen ? Face::body_bold : Face::body,
                      ui[!t.enabled    ? Tone::ink3
                         : i == chosen ? Tone::ink
                                       : Tone::ink2],
                      name);
    draw_ring(ui, t);
    if (t.clicked && i != chosen) picked = i;
    x = t.rect.max.x;
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(total, h));
  return picked;
}

int dropdown(Ui& ui, std::string_view id, std::string_view label, std::span<const std::string_view> names,
             int chosen, const DropdownOptions& o) {
  const std::string_view now = chosen >= 0 && chosen < static_cast<int>(names.size())
                                   ? names[static_cast<std::size_t>(chosen)]
                                   : o.none;
  const bool none = chosen < 0;
  const float w = o.width == 0 ? widest(ui, names) + ui.px(36) : width_px(ui, o.width);
  const Touch t =
      touch(ui, {id, Kind::list, label, now, o.disabled, false, o.tip}, ImVec2(w, ui.px(o.height)));
  if (t.enabled) draw_fill(ui, t.rect, ui[t.held ? Tone::sel : t.hovered ? Tone::hover : Tone::raised]);
  if (!t.enabled || o.error) draw_outline(ui, t.rect, ui[o.error ? Tone::fault : Tone::line]);
  const float middle = std::floor(t.rect.centre().y);
  const ImU32 ink = ui[t.enabled && !none ? Tone::ink : Tone::ink3];
  draw_text_in_two_lines(ui, t.rect.min.x + ui.px(10), t.rect.max.x - ui.px(26), middle,
                         none ? Face::body : Face::body_medium, ink, now);
  draw_icon(ImGui::GetWindowDrawList(), Icon::chevron_down, ImVec2(t.rect.max.x - ui.px(16), middle),
            ui.px(12), ui[t.enabled ? Tone::ink2 : Tone::ink3]);
  draw_ring(ui, t);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  const int picked = list_under(ui, id, t, names, chosen);
  ImGui::SetCursorScreenPos(after);
  return picked;
}

int menu(Ui& ui, std::string_view id, std::string_view label, std::span<const std::string_view> names,
         std::string_view disabled, float height, bool titled) {
  ButtonOptions options;
  if (titled) options.icon_after = Icon::chevron_down;
  options.style = ButtonStyle::quiet;
  options.disabled = disabled;
  options.height = height;
  const Touch t = button(ui, id, label, options);
  return list_under(ui, id, t, names, -1);
}

}  // namespace hw::gui
