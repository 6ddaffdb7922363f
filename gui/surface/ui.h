#pragma once
// Everything a widget or panel draws with: theme, type, scale, clock and input of one frame.
//
// How a panel uses the toolkit
//   - A panel gets a `Ui& ui` and draws with plain functions, one call per widget, each frame anew:
//         if (button(ui, "program/run", "Run", {.icon = Icon::play, .moving = true}).clicked) send(Run{});
//     The first text is the widget's path: our words in lower case, the maker's own as the maker writes them.
//     It is its id for scripts, tests and the focus order, so it must be the same in every frame and unique.
//   - Lengths in calls are logical pixels of the 4 px grid (4, 8, 12, 16, 24). The widgets scale and round;
//     code that draws directly uses ui.px(12) and ui.hair(), and so lands on whole pixels.
//   - Colours by token only: ui[Tone::warn]. Type by face only: ui.font(Face::body).
//   - Widgets stand at ImGui's cursor and advance it like ImGui items: ImGui::SameLine(), BeginChild and
//     SetCursorScreenPos work. A width of 0 is the natural one, `fill` takes the rest of the line.
//   - Text: text(ui, Face::body, Tone::ink2, "...") at the cursor, wrapped(...) for sentences,
//     draw_text / draw_text_right for exact places. Column furniture: section_title, group_line, key_value.
//   - Numbers that a person types: number_field with a NumberField that the panel keeps; comma and point both
//     read, the wheel changes nothing, a wrong value turns red with the range in words and is not reported.
//   - Enabled and why not: every options struct has `disabled`: a sentence; empty means enabled. Say when it
//     ends. It is shown as a tooltip; draw it beside the control where there is room.
//   - Motion: set `.moving = true` on each control that can start motion: it gets the cyan edge, needs a
//     second press by keyboard, and ignores a press until it has stood still for a while (standing.h). Its
//     place must not depend on the length of a text: keep room for the longest.
//     hold_button gives started / held / ended, with the times of the input, not of the frame.
//   - draw_text_line cuts what is too long; the whole text is shown under the mouse, automatically.
//   - A widget that changes with time alone (an expiring toast, "Attempt 5 in 3 s") calls ui.wake_in(), else
//     no frame is drawn: a console at rest draws nothing. No widget may call it in every frame at rest.
//   - A list or panel that needs the arrow keys calls ui.take_arrows() in the frame, else they jog. Esc
//     closes it and also stops all controllers; the console then names the motions that were stopped.
//   - Esc always stops all controllers before a panel receives it; ui.cancelled() is true in that frame, to
//     close a popup or dialog as well.
//   - Headless: Offscreen gives the same Ui without a display; tests draw a panel, push input through
//     Automation (click, press, type ...) and look at the registry or at pixels.
//   - No allocation at rest: format into stack buffers, keep view state in the panel's own members.
#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "core/base/fixed_text.h"
#include "gui/input/focus.h"
#include "gui/input/gamepad.h"
#include "gui/input/input_queue.h"
#include "gui/input/keyboard.h"
#include "gui/input/registry.h"
#include "gui/input/standing.h"
#include "gui/surface/fonts.h"
#include "gui/surface/pictures.h"
#include "gui/surface/theme.h"

namespace hw::gui {

/// As a width: the rest of the line.
inline constexpr float fill = -1;

class Ui {
 public:
  Ui(const Theme& t, const Fonts& f, Registry& r, Focus& fo, Standing& st, Keyboard& k, Gamepad& pad,
     InputQueue& in, Pictures& p, double now, ImVec2 size)
      : theme(t),
        fonts(f),
        registry(r),
        focus(fo),
        standing(st),
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
  Standing& standing;
  Keyboard& keyboard;
  Gamepad& gamepad;
  InputQueue& input;
  Pictures& pictures;
  const float scale;     ///< physical over logical pixels
  const double now_s;    ///< clock of the frames; virtual in headless runs
  const ImVec2 size_px;  ///< of the window

  /// Logical to whole physical pixels.
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

  /// Draws the next widgets as if touched in this way: for pictures of all states (tests/gui gallery).
  enum class Pretend : std::uint8_t { nothing, hovered, held, ring };
  Pretend pretend = Pretend::nothing;

  /// In this frame the user types into something other than ImGui's InputText.
  void note_typing() { typing_ = true; }
  /// The field being typed into keeps Tab for itself, or Shift Tab too.
  void take_tab(TabTaken taken = TabTaken::forward) { tab_taken_ = taken; }
  void take_arrows() { takes_arrows_ = true; }
  [[nodiscard]] bool typing() const { return typing_; }
  [[nodiscard]] TabTaken tab_taken() const { return tab_taken_; }
  [[nodiscard]] bool takes_arrows() const { return takes_arrows_; }
  // A text that was cut is shown whole under the mouse, unless its widget has a tip of its own.
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
