#include "gui/widgets/area.h"

#include <imgui_internal.h>

namespace hw::gui {

void begin_part(Ui& ui, const char* name, float width, float height, Tone ground, float padding,
                bool scrolls) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(padding), 0));
  // Regions have this tone already, and without a graphics card each filled pixel costs time.
  const bool shines_through = ground == Tone::panel;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, shines_through ? 0 : ui[ground]);
  ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoNav;
  if (!scrolls) {
    flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    // Scrolling to a widget inside the part would scroll the part too, and nothing could scroll it back.
    ImGui::SetNextWindowScroll(ImVec2(0, 0));
  }
  ImGui::BeginChild(name, ImVec2(width, height), false, flags);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  use_whole_window();
  // The scrollbar lies inside the padding, so that nothing moves when it appears or disappears.
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const float right = window->Pos.x + window->SizeFull.x - ui.px(padding);
  if (window->ScrollbarSizes.x > 0 && padding > 12) {
    window->ContentRegionRect.Max.x = right;
    window->WorkRect.Max.x = right;
  }
}

void end_part() {
  ImGui::PopClipRect();
  ImGui::EndChild();
}

void line_right_of(Ui& ui, const Rect& r) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(r.max.x - ui.hair(), r.min.y), r.max, ui[Tone::line]);
}

void line_below(Ui& ui, const Rect& r) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(r.min.x, r.max.y - ui.hair()), r.max, ui[Tone::line]);
}

}  // namespace hw::gui
