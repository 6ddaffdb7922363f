#include "gui/widgets/region.h"

#include <cstdio>

#include <imgui_internal.h>

namespace hw::gui {

void begin_region(Ui& ui, const char* name, const Rect& where, Tone ground, ImVec2 padding, bool scrolls) {
  ImGui::SetNextWindowPos(where.min);
  ImGui::SetNextWindowSize(ImVec2(std::max(1.0f, where.width()), std::max(1.0f, where.height())));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.px(padding.x, padding.y));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui[ground]);
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                           ImGuiWindowFlags_NoNav;
  if (scrolls)
    flags &= ~(ImGuiWindowFlags_NoScrollbar);
  else
    flags |= ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::Begin(name, nullptr, flags);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  use_whole_window();
}

void end_region() {
  ImGui::PopClipRect();
  ImGui::End();
}

void use_whole_window() {
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  ImRect inside = window->InnerRect;
  inside.ClipWith(window->OuterRectClipped);
  ImGui::PushClipRect(inside.Min, inside.Max, false);
}

void bring_to_front() {
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  for (const ImGuiPopupData& popup : ImGui::GetCurrentContext()->OpenPopupStack)
    if (popup.Window) ImGui::BringWindowToDisplayFront(popup.Window);
}

/// The border needs a window of its own, because the parts on both sides reach up to it.
static void begin_border(std::string_view id, const Rect& hit) {
  char name[64];
  std::snprintf(name, sizeof name, "##%.*s", static_cast<int>(id.size()), id.data());
  ImGui::SetNextWindowPos(hit.min);
  ImGui::SetNextWindowSize(ImVec2(hit.width(), hit.height()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (ImGui::IsWindowAppearing()) bring_to_front();
}

bool splitter(Ui& ui, std::string_view id, const Rect& border, bool vertical, float& size,
              const SplitRange& range, int towards) {
  const float grab = ui.px(4);
  Rect hit = border;
  (vertical ? hit.min.x : hit.min.y) -= grab;
  (vertical ? hit.max.x : hit.max.y) += grab;
  begin_border(id, hit);
  char value[24];
  std::snprintf(value, sizeof value, "%.0f", static_cast<double>(size));
  const Touch t = touch(ui, {id, Kind::slider, "size of the column", value, {}, false, {}},
                        ImVec2(hit.width(), hit.height()));
  const float before = size;
  if (t.hovered || t.held)
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (t.held && ImGui::IsMouseDown(0)) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const float step = static_cast<float>(towards) * (vertical ? moved.x : moved.y) / ui.scale;
    if (step != 0) size = std::clamp(size + step, range.min, range.max);
  }
  if (t.ring)
    for (ImWchar c : ImGui::GetIO().InputQueueCharacters)
      if (c == '+' || c == '-') size = std::clamp(size + (c == '+' ? 16.0f : -16.0f), range.min, range.max);
  if (t.double_clicked) size = range.normal;
  ImGui::GetWindowDrawList()->AddRectFilled(border.min, border.max,
                                            ui[t.held || t.hovered || t.ring ? Tone::edge : Tone::line]);
  ImGui::End();
  return size != before;
}

}  // namespace hw::gui
