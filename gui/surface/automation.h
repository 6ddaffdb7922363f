#pragma once
// User input for scripts and tests. Finds a widget by its id, then presses, types and reads as a user would,
// through the same input queue. An action that a user could not do (the widget is unknown, disabled, covered
// or out of reach) fails with a sentence.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "gui/surface/screen.h"

namespace hw::gui {

class Automation {
 public:
  /// `run_frame` advances the clock by one frame and draws it. `now_s` reads that clock. No further frame is
  /// drawn once `over` returns true.
  Automation(
      Surface& surface, std::function<void()> run_frame, std::function<double()> now_s,
      std::function<bool()> over = [] { return false; });

  // A press on a button that can start motion waits until the button accepts it: see press_guard.h.

  Result<> click(std::string_view id);
  /// Presses the mouse button on the widget and keeps it down until release().
  Result<> press(std::string_view id);
  Result<> release(std::string_view id);
  /// Drags the first widget onto another widget that is in view: onto its middle, or this share of its
  /// height.
  Result<> drag(std::string_view id, std::string_view onto, float share = 0.5f);
  /// Replaces the content of a field; '\n' is Enter. In an editor: types at the end of the text.
  Result<> type(std::string_view id, std::string_view text);
  /// Presses and releases "Escape", "Ctrl+Enter", "F5", "Left", "?", "a".
  Result<> key(std::string_view chord);
  /// Only the press or the release, for holding a jog key.
  Result<> key_down(std::string_view chord);
  Result<> key_up(std::string_view chord);
  // These functions draw a frame first, so that the result is never out of date.

  /// The value that the widget shows, as plain ASCII.
  Result<std::string> value(std::string_view id);
  bool exists(std::string_view id);

  struct Listed {
    std::string id, kind, label, value;
    float x, y, width, height;  ///< logical pixels
    bool enabled, moving;
  };
  std::vector<Listed> list();

  void frame(int n = 1);
  Result<> screenshot(const std::string& path);
  Result<> window(int width, int height, float scale = 1);
  Result<> theme(std::string_view name);
  /// Takes the keyboard from the window, as a click on another window does.
  void lose_focus();

 private:
  Result<const Widget*> reach(std::string_view id);
  Result<> usable(std::string_view id);
  Result<> wait_until_settled(std::string_view id);
  void point_at(ImVec2 at);
  void push_button(bool down);
  void push_text(std::string_view text);
  void settle();
  void take_input();
  void tap(int key);

  Surface& surface_;
  std::function<void()> run_frame_;
  std::function<double()> now_s_;
  std::function<bool()> over_;
  std::string pressed_;
};

/// The GLFW key and modifiers of "Ctrl+Shift+Tab"; a fault when there is no such key.
struct Chord {
  int key = 0;
  bool ctrl = false, shift = false, alt = false;
  unsigned text = 0;  ///< the character it types, if any
};
Result<Chord> read_chord(std::string_view text);

}  // namespace hw::gui
