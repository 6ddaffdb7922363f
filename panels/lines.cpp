#include "panels/lines.h"

#include <algorithm>

#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "panels/measures.h"

namespace hw::panels {

using namespace gui;

void draw_line_across(const Frame& f, float y) {
  Ui& ui = f.ui;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(ui.px(f.area.x), y),
                                            ImVec2(ui.px(f.area.right()), y + ui.hair()), ui[Tone::line]);
}

void draw_line_down(const Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + ui.hair(), ui.px(f.area.bottom())),
                                            ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.hair(), at.y));
}

ImVec2 begin_toolbar(const Frame& f) {
  const ImVec2 corner(f.ui.px(f.area.x), ImGui::GetCursorScreenPos().y);
  ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + 16), corner.y + f.ui.px(8)));
  return corner;
}

void next_in_toolbar(const Frame& f, float gap, float width) {
  constexpr float half = 20;  // of the height of a button
  const Ui& ui = f.ui;
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  const float middle = (from.y + to.y) / 2;
  const bool fits = to.x + ui.px(gap + width + 8) <= ui.px(f.area.right());
  ImGui::SetCursorScreenPos(fits ? ImVec2(to.x + ui.px(gap), middle - ui.px(half))
                                 : ImVec2(ui.px(f.area.x + 16), middle + ui.px(half + 8)));
}

void end_toolbar(const Frame& f, ImVec2 corner) {
  const float bottom = std::max(corner.y + f.ui.px(toolbar_height), ImGui::GetItemRectMax().y + f.ui.px(8));
  draw_line_across(f, bottom - f.ui.hair());
  ImGui::SetCursorScreenPos(ImVec2(corner.x, bottom));
}

}  // namespace hw::panels
