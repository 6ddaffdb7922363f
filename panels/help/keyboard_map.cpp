#include "panels/help/keyboard_map.h"

#include <cmath>
#include <span>

#include "gui/input/gamepad.h"
#include "gui/input/keyboard.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

/// Draws a key in a frame, like a keycap.
void draw_key(Ui& ui, ImVec2 at, std::string_view keys) {
  const float width = std::ceil(text_width(ui, Face::body_bold, keys)) + ui.px(16);
  const Rect r{ImVec2(at.x, at.y + ui.px(4)), ImVec2(at.x + width, at.y + ui.px(28))};
  draw_outline(ui, r, ui[Tone::edge]);
  draw_text_centred(ui, r, Face::body_bold, ui[Tone::ink], keys);
}

struct Key {
  std::string_view keys, does;
};
constexpr Key in_editor[] = {
    {"Ctrl Z", "Undo"},
    {"Ctrl Y", "Redo, also Ctrl Shift Z"},
    {"Ctrl X  C  V", "Cut, copy, paste"},
    {"Ctrl A", "Select all"},
    {"Ctrl F", "Find; F3 finds the next"},
    {"Ctrl /", "Comment or uncomment lines"},
    {"Ctrl ]  [", "Indent or unindent the line"},
    {"Tab", "Indent the lines chosen, Shift Tab back; else leave"},
};
constexpr Key in_terminal[] = {
    {"Enter", "Send the line"},
    {"Tab", "Complete, or list the possible commands"},
    {"Up  Down", "Earlier lines, or along the list"},
    {"Ctrl C", "Copy the lines chosen with the mouse"},
};

constexpr std::string_view rules[] = {
    "Tap a jog key to move one step. Hold it for a quarter of a second or longer, and the axis runs until "
    "you let go.",
    "Letting go, losing the window, changing the controller or Esc ends a held jog.",
    "Tab and Shift Tab go from control to control, out of the program too. A cyan edge marks a control that "
    "moves metal: by keyboard it needs two presses within two seconds.",
    "While you type, the arrows move the caret and jog nothing. Esc stops everything all the same.",
    "Esc in an open list or dialog closes it, stops everything, and reports what was stopped.",
    "Wire a switch that cuts the motor power. Esc is no emergency stop: it needs this computer, the cable "
    "and a controller that listens.",
};

constexpr std::string_view pad_rules[] = {
    "A gamepad acts while it is armed, by the switch beside the jog buttons. Hold LB first, then push: a "
    "stick pushed before LB moves nothing.",
    "A stick moves one axis at a time, in the direction pushed most, at the jog speed: it is on or off.",
    "Whatever ends a held jog ends the gamepad's jog too. The gamepad is disarmed when the window loses the "
    "keyboard, when it is unplugged, and when it does not answer. If nothing on it changes for 2 s, its jog "
    "stops: let go, then push again.",
};

/// Draws a row of 32: the framed key, its function, a hairline above.
void draw_row(Ui& ui, const Key& key, float width, int number) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + ui.px(width), at.y + ui.hair()),
                                            ui[Tone::line]);
  draw_key(ui, at, key.keys);
  draw_text_in_two_lines(ui, at.x + ui.px(136), at.x + ui.px(width), at.y + ui.px(16), Face::body,
                         ui[Tone::ink], key.does);
  show(ui, {Path("help/{}", number), Kind::text, key.keys, key.does, {}, false, {}},
       {at, ImVec2(at.x + ui.px(width), at.y + ui.px(32))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(32)));
}

void draw_rules(Ui& ui, std::span<const std::string_view> all, float width) {
  gap(ui, 8);
  for (const std::string_view rule : all) {
    wrapped(ui, Face::body, Tone::ink2, rule, width);
    gap(ui, 8);
  }
  gap(ui, 8);
}

}  // namespace

void draw_keyboard_map(PageFrame& f, float width) {
  Ui& ui = f.ui;
  int number = 0;
  section_title(ui, "Everywhere");
  for (const Shortcut& shortcut : shortcuts())
    if (!shortcut.keys.empty()) draw_row(ui, {shortcut.keys, shortcut.does}, width, ++number);
  section_title(ui, "In the program", {}, 48);
  for (const Key& key : in_editor) draw_row(ui, key, width, ++number);
  section_title(ui, "In the terminal", {}, 48);
  for (const Key& key : in_terminal) draw_row(ui, key, width, ++number);
  section_title(ui, "On a gamepad", {}, 48);
  for (const PadControl& pad : gamepad_map()) draw_row(ui, {pad.control, pad.does}, width, ++number);
  draw_rules(ui, pad_rules, width);
  section_title(ui, "For keyboard, mouse and gamepad", {}, 48);
  draw_rules(ui, rules, width);
}

}  // namespace hw::panels
