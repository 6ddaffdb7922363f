#include "gui/widgets/popup.h"

#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"

namespace hw::gui {

bool begin_popup(Ui& ui, const char* name, const Touch& button, float width, float rows, bool right) {
  if (button.clicked) ImGui::OpenPopup(name);
  const float w = std::max(ui.px(width), button.rect.width());
  Rect opener = button.rect;
  if (right) opener.min.x = opener.max.x - w;
  const Rect place = place_list(ui, opener, w, std::floor(ui.px(32) * rows) + 2 * ui.px(4));
  ImGui::SetNextWindowPos(place.min);
  ImGui::SetNextWindowSize(ImVec2(w, place.height()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.hair(), ui.px(4)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_PopupBorderSize, ui.hair());
  const bool open = ImGui::BeginPopup(name, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  if (!open) {
    ImGui::PopStyleVar(3);
    return false;
  }
  ui.take_arrows();
  if (ui.cancelled()) ImGui::CloseCurrentPopup();
  return true;
}

bool popup_row(Ui& ui, std::string_view id, std::string_view label, std::string_view caption, bool on,
               std::string_view disabled) {
  const float width = ImGui::GetContentRegionAvail().x;
  const Touch t =
      touch(ui, {id, Kind::row, label, on ? "on" : caption, disabled, false, {}}, ImVec2(width, ui.px(32)));
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (t.enabled && (on || t.hovered))
    list->AddRectFilled(t.rect.min, t.rect.max, ui[t.hovered ? Tone::hover : Tone::sel]);
  if (on) list->AddRectFilled(t.rect.min, ImVec2(t.rect.min.x + ui.px(3), t.rect.max.y), ui[Tone::ink]);
  const float middle = t.rect.centre().y, right = t.rect.max.x - ui.px(12);
  const float caption_width = caption.empty() ? 0 : std::ceil(text_width(ui, Face::small, caption));
  draw_text_line(ui, t.rect.min.x + ui.px(12), right - caption_width, middle,
                 on ? Face::body_bold : Face::body, ui[t.enabled ? Tone::ink : Tone::ink3], label);
  if (!caption.empty())
    draw_text_line(ui, right - caption_width, right + 1, middle, Face::small, ui[Tone::ink2], caption);
  if (t.ring) draw_outline(ui, t.rect, ui[Tone::ink], 0, ui.px(2));
  if (t.clicked) ImGui::CloseCurrentPopup();
  return t.clicked;
}

void popup_line(Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(
      at, ImVec2(at.x + ImGui::GetContentRegionAvail().x, at.y + ui.hair()), ui[Tone::line]);
}

void end_popup() {
  ImGui::EndPopup();
  ImGui::PopStyleVar(3);
}

}  // namespace hw::gui
