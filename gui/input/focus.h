#pragma once
// The focus follows the Tab order: every enabled widget of the top layer, in drawing order. ImGui's own
// navigation stays off, because it stops only at fields and takes the arrow keys from jogging. The ring is
// shown only after Tab; a click moves the focus without it.
#include <cstdint>
#include <string>
#include <string_view>

#include <imgui.h>

#include "gui/input/registry.h"

namespace hw::gui {

/// The Tab keys that the field being typed into keeps for itself.
enum class TabTaken : std::uint8_t { no, forward, both };

class Focus {
 public:
  /// Time of the frame and of the key event in it, in seconds.
  struct Times {
    double now_s, key_moved_at_s;
  };
  /// Call once in a frame, after ImGui::NewFrame. `typing`: a field has ImGui's keyboard; `taken`: the Tab
  /// keys that it keeps.
  void begin_frame(Registry& registry, Times times, bool typing, TabTaken taken);

  /// Call at the end of a frame. `typing`: a field has the keyboard now.
  void end_frame(bool typing);
  /// True while a field is about to get the keyboard. Text typed meanwhile is for the field, and an arrow key
  /// must not jog.
  [[nodiscard]] bool entering() const { return !entry_.empty() || frames_to_entry_ > 0; }

  /// Sets the focus as a click does, without the ring.
  void set(std::string_view id);
  /// Sets the focus as Tab does, with the ring; a field gets the keyboard.
  void move_to(std::string_view id);
  [[nodiscard]] std::string_view id() const { return id_; }
  [[nodiscard]] bool is(std::string_view id) const { return id_ == id && !id_.empty(); }
  [[nodiscard]] bool ring_on(std::string_view id) const { return visible_ && is(id); }
  /// Called by a field: returns true, once, when it must take the keyboard now.
  bool take_entry(std::string_view id);

  /// Whether Enter or Space has pressed the widget with the ring in this frame.
  [[nodiscard]] bool key_started(std::string_view id) const { return started_ && ring_on(id); }
  [[nodiscard]] bool key_held(std::string_view id) const { return held_ && ring_on(id); }
  [[nodiscard]] bool key_ended(std::string_view id) const { return ended_ && is(id); }
  [[nodiscard]] double key_pressed_at_s() const { return pressed_at_s_; }
  [[nodiscard]] double key_released_at_s() const { return released_at_s_; }
  /// Time of the key event that presses or releases a widget in this frame; negative: none.
  [[nodiscard]] double key_acted_at_s() const {
    return started_ ? pressed_at_s_ : ended_ ? released_at_s_ : -1;
  }
  /// The first press of a widget that can start motion only arms it for two seconds, so that an accidental
  /// Tab and Enter moves nothing.
  [[nodiscard]] bool armed(std::string_view id, double now_s) const {
    return is(id) && now_s < armed_until_s_;
  }

 private:
  void step(const Registry& registry, int direction);
  void read_activation(const Registry& registry, Times times);

  std::string id_, entry_;
  bool visible_ = false, started_ = false, held_ = false, ended_ = false;
  bool entry_is_old_ = false;
  int frames_to_entry_ = 0;
  double armed_until_s_ = -1, pressed_at_s_ = 0, released_at_s_ = 0;
};

}  // namespace hw::gui
