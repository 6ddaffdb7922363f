// Draws the program's log on the connection page, because a controller that cannot be opened has no tab to
// show it.
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/connect/connect.h"

namespace hw::panels {

using namespace gui;

void Connect::draw_log_button(PageFrame& f) {
  gap(f.ui, 16);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x - f.ui.px(12), at.y));  // aligns its words with the column's edge
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.tip = "Why a port was not opened, or a controller refused or was lost.";
  if (button(f.ui, "connect/log", "Log of this program", o).clicked) log_shown_ = true;
}

void Connect::draw_log(PageFrame& f) {
  Ui& ui = f.ui;
  const Box& a = f.area;
  constexpr float head = 56;
  begin_part(ui, "log", ui.px(a.width), ui.px(a.height), Tone::panel, 0, false);
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.icon = Icon::chevron_left;
  const float back = button_width(ui, "Connections", o);
  ImGui::SetCursorScreenPos(ui.px(a.x + 4, a.y + 12));
  if (button(ui, "connect/log/close", "Connections", o).clicked) log_shown_ = false;
  log_.draw_tools(f, ui.px(a.x + 20 + back), ui.px(a.right() - 16), ui.px(a.y + 12));
  ImGui::SetCursorScreenPos(ui.px(a.x, a.y + head));
  log_.draw(f, ui.px(a.height - head));
  end_part();
}

}  // namespace hw::panels
