#include "panels/help.h"

#include "gui/area.h"
#include "gui/console.h"
#include "gui/keyboard.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;

namespace {

/// A key in its frame, as a caption on a keyboard.
void draw_key(Ui& ui, ImVec2 at, std::string_view keys) {
  const float width = std::ceil(text_width(ui, Face::body_bold, keys)) + ui.px(16);
  const Rect r{ImVec2(at.x, at.y + ui.px(4)), ImVec2(at.x + width, at.y + ui.px(28))};
  draw_outline(ui, r, ui[Tone::edge]);
  draw_text_centred(ui, r, Face::body_bold, ui[Tone::ink], keys);
}

constexpr std::string_view rules[] = {
    "A jog key held for less than a quarter of a second moves one step; longer, the axis runs until you let "
    "go.",
    "Letting go, losing the window, changing the controller or Esc ends a held jog.",
    "Tab and Shift Tab go from control to control; a cyan edge marks what moves metal, and by keyboard it "
    "needs two "
    "presses within two seconds.",
    "While you type, the arrows move the caret and jog nothing. Esc stops everything all the same.",
};

}  // namespace

void Help::draw(PageFrame& f) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(ui.px(f.area.x, f.area.y));
  begin_part(ui, "map", ui.px(f.area.width), ui.px(f.area.height), Tone::panel, 24);
  const float width = std::min(f.area.width - 48 - 12, 760.0f);
  section_title(ui, "Keyboard map", {}, 56);
  int number = 0;
  for (const Shortcut& shortcut : shortcuts()) {
    if (shortcut.keys.empty()) continue;
    group_line(ui, 0);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_key(ui, at, shortcut.keys);
    draw_text_line(ui, at.x + ui.px(168), at.x + ui.px(width), at.y + ui.px(16), Face::body, ui[Tone::ink],
                   shortcut.does);
    show(ui, {Path("help/{}", ++number), Kind::text, shortcut.keys, shortcut.does, {}, false, {}},
         {at, ImVec2(at.x + ui.px(width), at.y + ui.px(32))});
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(32)));
  }
  group_line(ui, 0);
  gap(ui, 16);
  for (const std::string_view rule : rules) {
    wrapped(ui, Face::body, Tone::ink2, rule, width);
    gap(ui, 8);
  }
  gap(ui, 8);
  if (button(ui, "help/back", "Back").clicked) f.console.toggle_map();
  gap(ui, 24);
  end_part();
}

StatusSentence Help::status(Console&) { return {Mood::plain, "Press ? again to go back."}; }

}  // namespace hw::panels
