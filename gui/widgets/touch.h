#pragma once
// Touching widgets: by mouse, by keyboard through the focus ring, by a script through the same input. Places
// the widget at ImGui's cursor, registers it, and reports the touch in this frame.
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
  bool always = false;  ///< STOP ALL: acts on the press, and under every dialog and list
  bool stops = false;   ///< a Stop
  bool card = false;    ///< the background of a card over other parts
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
  bool ring = false;                           ///< shows the focus ring
  bool armed = false;                          ///< pressed once by keyboard; the second press moves
  bool not_taken = false;                      ///< a press came before it had stood still, and was ignored
};

/// `size` in pixels.
Touch touch(Ui& ui, const About& about, ImVec2 size);
/// The same for widgets that cannot be pressed (lamps, meters): registers the last ImGui item's place or
/// `rect`.
void show(Ui& ui, const About& about, const Rect& rect);
/// 2 px ring, 2 px outside the control; dashes around a control whose press was ignored.
void draw_ring(Ui& ui, const Touch& t);
/// Outline of `hair` width that lies on whole pixels inside `r`.
void draw_outline(Ui& ui, const Rect& r, ImU32 colour, float rounding = 3, float width = 0);
void draw_dashed_outline(Ui& ui, const Rect& r, ImU32 colour);
/// The 2 px line along the bottom of controls that move metal.
void draw_motion_edge(Ui& ui, const Rect& r, ImU32 colour);
void draw_fill(Ui& ui, const Rect& r, ImU32 colour, float rounding = 3);

}  // namespace hw::gui
