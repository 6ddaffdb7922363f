#include "panels/help/help.h"

#include <algorithm>

#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/help/keyboard_map.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float sheet_head = 48, sheet_side = 16;

/// The page about the controller in front is named after its model.
std::string_view page_of(Console& console) {
  const Tab* tab = console.active();
  return tab ? std::string_view(tab->catalog().model) : std::string_view();
}

}  // namespace

void Help::draw(PageFrame& f) {
  Ui& ui = f.ui;
  draw_head(f);
  const float top = f.area.y + sheet_head;
  ImGui::SetCursorScreenPos(ui.px(f.area.x, top));
  begin_part(ui, shows_manual_ ? "manual" : "keys", ui.px(f.area.width),
             std::max(1.0f, ui.px(f.area.bottom()) - ui.px(top)), Tone::panel, sheet_side);
  if (shows_manual_)
    manual_.draw(f, page_of(f.console));
  else
    draw_keyboard_map(f, f.area.width - 2 * sheet_side);
  end_part();
}

void Help::draw_head(PageFrame& f) {
  Ui& ui = f.ui;
  const float y = f.area.y + (sheet_head - 32) / 2;
  constexpr std::string_view parts[] = {"Keys", "Manual"};
  ImGui::SetCursorScreenPos(ui.px(f.area.x + sheet_side, y));
  const int chosen = segment(ui, "help/show", parts, shows_manual_ ? 1 : 0);
  if (chosen >= 0) shows_manual_ = chosen == 1;
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.width = 32;
  o.icon = Icon::cross;
  o.tip = "Close the help";
  const float close = f.area.right() - 8 - o.width;
  ImGui::SetCursorScreenPos(ui.px(close, y));
  if (button(ui, "help/close", "", o).clicked) f.console.toggle_help();
  float end = close;
  if (shows_manual_) {
    o.width = 0;
    o.icon = Icon::none;
    o.disabled = manual_.shows_contents() ? "This is the list of all pages." : "";
    o.tip = "The list of all pages";
    end -= button_width(ui, "Pages", o);
    ImGui::SetCursorScreenPos(ui.px(end, y));
    if (button(ui, "help/pages", "Pages", o).clicked) manual_.open("");
    o.disabled = manual_.can_go_back() ? "" : "No page was shown before this one.";
    o.tip = "The page before";
    end -= button_width(ui, "Back", o) + 4;
    ImGui::SetCursorScreenPos(ui.px(end, y));
    if (button(ui, "help/back", "Back", o).clicked) manual_.go_back();
  }
  const std::string_view title = shows_manual_ ? manual_.title() : "Keys and gamepad";
  show(ui, {"help/title", Kind::text, title, title}, {ui.px(f.area.x, f.area.y), ui.px(end, y)});
  ImGui::GetWindowDrawList()->AddRectFilled(
      ui.px(f.area.x, f.area.y + sheet_head - 1),
      ImVec2(ui.px(f.area.right()), ui.px(f.area.y + sheet_head - 1) + ui.hair()), ui[Tone::line]);
}

}  // namespace hw::panels
