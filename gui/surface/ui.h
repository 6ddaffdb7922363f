#pragma once
// Gives widgets and panels all that they need to draw a frame: theme, type, scale, clock and input.
//
// How a panel uses the toolkit
//   - A panel gets a `Ui& ui` and draws with plain functions, one call per widget, anew in each frame:
//         if (button(ui, "program/run", "Run", {.icon = Icon::play, .moving = true}).clicked) send(Run{});
//     The first text is the widget's id for scripts, tests and the focus order: a path, unique, and the same
//     in every frame. Our words in it are in lower case; a maker's own word is written as the maker writes
//     it.
//   - Lengths in calls are logical pixels of the 4 px grid (4, 8, 12, 16, 24). The widgets scale and round
//     them; code that draws directly uses ui.px(12) and ui.hair() to get whole pixels.
//   - Take colours by token: ui[Tone::warn]. Take type by face: ui.font(Face::body).
//   - Widgets are placed at ImGui's cursor and advance it like ImGui items: ImGui::SameLine(), BeginChild and
//     SetCursorScreenPos work. Width 0 is the natural width; `fill` takes the rest of the line.
//   - Text: text(ui, Face::body, Tone::ink2, "...") at the cursor, wrapped(...) for sentences, draw_text and
//     draw_text_right for exact places. For columns: section_title, group_line, key_value.
//   - Numbers that the user types: number_field with a NumberField that the panel keeps. It reads comma and
//     point and ignores the mouse wheel. A wrong value turns red, with the range in words, and is not
//     committed.
//   - Every options struct has `disabled`: a sentence that says why the control is disabled and until when;
//     empty means enabled. It is shown as a tooltip; draw it beside the control too if there is space.
//   - Motion: set `.moving = true` on each control that can start motion. It gets the cyan edge, needs a
//     second press by keyboard, and ignores a press until it has been in its place for a while
//     (press_guard.h). Its place must not depend on the length of a text: reserve the width of the longest.
//     hold_button gives started / held / ended, with the times of the input, not of the frame.
//   - draw_text_line cuts a text that is too long; the tip then shows the whole text.
//   - A widget that changes with time alone (an expiring toast, "Attempt 5 in 3 s") calls ui.wake_in();
//     otherwise no frame is drawn. A console at rest draws nothing, so no widget calls it in every frame at
//     rest.
//   - A list or panel that needs the arrow keys calls ui.take_arrows() in each frame; otherwise they jog.
//   - Esc stops all controllers before a panel receives it. ui.cancelled() is true in that frame, so that a
//     list, popup or dialog closes too. The console then names the motions that were stopped.
//   - Headless: Offscreen gives the same Ui without a display. Tests draw a panel, push input through
//     Automation (click, press, type ...) and look at the registry or at pixels.
//   - Allocate nothing at rest: format into stack buffers, and keep view state in the panel's own members.
#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "core/base/fixed_text.h"
#include "gui/input/focus.h"
#include "gui/input/gamepad.h"
#include "gui/input/input_queue.h"
#include "gui/input/keyboard.h"
#include "gui/input/press_guard.h"
#include "gui/input/registry.h"
#include "gui/surface/fonts.h"
#include "gui/surface/pictures.h"
#include "gui/surface/theme.h"

namespace hw::gui {

/// A width that takes the rest of the line.
inline constexpr float fill = -1;

class Ui {
 public:
  Ui(const Theme& t, const Fonts& f, Registry& r, Focus& fo, PressGuard& st, Keyboard& k, Gamepad& pad,
     InputQueue& in, Pictures& p, double now, ImVec2 size)
      : theme(t),
        fonts(f),
        registry(r),
        focus(fo),
        press_guard(st),
        keyboard(k),
        gamepad(pad),
        input(in),
        pictures(p),
        scale(f.scale()),
        now_s(now),
        size_px(size) {}

  const Theme& theme;
  const Fonts& fonts;
  Registry& registry;
  Focus& focus;
  PressGuard& press_guard;
  Keyboard& keyboard;
  Gamepad& gamepad;
  InputQueue& input;
  Pictures& pictures;
  const float scale;     ///< physical over logical pixels
  const double now_s;    ///< clock of the frames; virtual in headless runs
  const ImVec2 size_px;  ///< of the window

  /// Converts logical to whole physical pixels.
  [[nodiscard]] float px(float logical) const { return std::floor(logical * scale + 0.5f); }
  [[nodiscard]] ImVec2 px(float x, float y) const { return ImVec2(px(x), px(y)); }
  /// Width of a hairline.
  [[nodiscard]] float hair() const { return std::max(1.0f, std::floor(scale)); }
  [[nodiscard]] ImU32 operator[](Tone t) const { return theme[t]; }
  [[nodiscard]] ImFont* font(Face f) const { return fonts[f]; }
  /// Line height of a face in pixels.
  [[nodiscard]] float line(Face f) const { return px(size_of(f).line); }

  /// Requests another frame after this time even if nothing happens.
  void wake_in(double seconds) { wake_in_s_ = std::min(wake_in_s_, std::max(0.0, seconds)); }
  [[nodiscard]] double wake_in_s() const { return wake_in_s_; }

  /// Draws the next widgets as if they were touched, for pictures of all states (tests/gui gallery).
  enum class Pretend : std::uint8_t { nothing, hovered, held, ring };
  Pretend pretend = Pretend::nothing;

  /// Call when the user types into a widget that is not ImGui's InputText, in each such frame.
  void note_typing() { typing_ = true; }
  /// Call when the field that the user types into keeps Tab, or Tab and Shift Tab, in each such frame.
  void take_tab(TabTaken taken = TabTaken::forward) { tab_taken_ = taken; }
  void take_arrows() { takes_arrows_ = true; }
  [[nodiscard]] bool typing() const { return typing_; }
  [[nodiscard]] TabTaken tab_taken() const { return tab_taken_; }
  [[nodiscard]] bool takes_arrows() const { return takes_arrows_; }
  // The tip shows a text that was cut, unless its widget has a tip of its own.
  void note_cut(std::string_view whole) const { cut_ = whole; }
  [[nodiscard]] std::string_view cut() const { return tip_shown_ ? std::string_view() : cut_.view(); }
  void note_tip() { tip_shown_ = true; }
  [[nodiscard]] bool cancelled() const { return keyboard.pressed(Command::stop_all); }

 private:
  double wake_in_s_ = 1e9;
  TabTaken tab_taken_ = TabTaken::no;
  bool typing_ = false, takes_arrows_ = false, tip_shown_ = false;
  mutable FixedText<640> cut_;
};

}  // namespace hw::gui
