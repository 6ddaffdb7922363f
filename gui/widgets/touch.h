#pragma once
// Touching a widget: with the mouse, with the keyboard through the focus ring, or by a script, which uses the
// same input.
#include <string_view>

#include "gui/surface/ui.h"

namespace hw::gui {

struct About {
  std::string_view id;
  Kind kind = Kind::button;
  std::string_view label;
  std::string_view value = {};
  std::string_view disabled = {};  ///< not empty: disabled, and why
  bool moving = false;             ///< can start motion
  std::string_view tip = {};
  bool always = false;  ///< STOP ALL: acts on the press, even under a dialog or list
  bool stops = false;   ///< a Stop
  bool card = false;    ///< the background of a card that lies over other parts
};

struct Touch {
  Rect rect;
  bool enabled = true;
  bool hovered = false;
  bool held = false;     ///< pressed now
  bool clicked = false;  ///< pressed and released on it, or Enter
  bool started = false;  ///< pressed in this frame
  bool ended = false;    ///< released in this frame, wherever the mouse is then
  bool double_clicked = false;
  double pressed_at_s = 0, released_at_s = 0;  ///< times of the input, not of the frame
  bool ring = false;                           ///< has the focus ring
  bool armed = false;          ///< pressed once by keyboard; the second press starts the motion
  bool press_ignored = false;  ///< a press was ignored because the widget had just moved
};

/// Places the widget at ImGui's cursor, registers it, and returns the touch of this frame. `size` is in
/// pixels.
Touch touch(Ui& ui, const About& about, ImVec2 size);
/// Registers a widget that cannot be pressed, such as a lamp or meter, at `rect`.
void show(Ui& ui, const About& about, const Rect& rect);
/// Draws a ring 2 px wide, 2 px outside of the control; dashed around a control that ignored a press.
void draw_ring(Ui& ui, const Touch& t);
/// Draws an outline on whole pixels inside `r`; width 0 takes a hairline.
void draw_outline(Ui& ui, const Rect& r, ImU32 colour, float rounding = 3, float width = 0);
void draw_dashed_outline(Ui& ui, const Rect& r, ImU32 colour);
/// The line, 2 px high, along the bottom of a control that can start motion.
void draw_motion_edge(Ui& ui, const Rect& r, ImU32 colour);
void draw_fill(Ui& ui, const Rect& r, ImU32 colour, float rounding = 3);

}  // namespace hw::gui
