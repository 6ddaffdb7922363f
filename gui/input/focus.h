#pragma once
// The order of Tab, from the registry: every enabled widget of the top layer, in drawing order. ImGui's own
// navigation stays off (it would stop at fields only and take the arrows that jog). The ring shows only after
// Tab; a click moves the focus without it.
#include <cstdint>
#include <string>
#include <string_view>

#include <imgui.h>

#include "gui/input/registry.h"

namespace hw::gui {

/// What a field that is being typed into keeps for itself.
enum class TabTaken : std::uint8_t { no, forward, both };

class Focus {
 public:
  /// Once a frame, after ImGui::NewFrame. `typing`: a field has ImGui's keyboard; `taken`: and what of Tab.
  void begin_frame(Registry& registry, double now_s, bool typing, TabTaken taken);

  /// At the frame's end. `typing`: a field has the keyboard now.
  void end_frame(bool typing);
  /// A field was asked to start typing and has not begun: what is typed meanwhile is meant for it, and an
  /// arrow must not jog.
  [[nodiscard]] bool entering() const { return !entry_.empty() || frames_to_entry_ > 0; }

  /// By a click: no ring.
  void set(std::string_view id);
  /// By code, as Tab would: with ring; a field starts typing.
  void move_to(std::string_view id);
  [[nodiscard]] std::string_view id() const { return id_; }
  [[nodiscard]] bool is(std::string_view id) const { return id_ == id && !id_.empty(); }
  [[nodiscard]] bool ring_on(std::string_view id) const { return visible_ && is(id); }
  /// A field asks whether it should start typing now; answers once.
  bool take_entry(std::string_view id);

  /// What Enter or Space does to the widget that has the ring, this frame.
  [[nodiscard]] bool key_started(std::string_view id) const { return started_ && ring_on(id); }
  [[nodiscard]] bool key_held(std::string_view id) const { return held_ && ring_on(id); }
  [[nodiscard]] bool key_ended(std::string_view id) const { return ended_ && is(id); }
  [[nodiscard]] double key_pressed_at_s() const { return pressed_at_s_; }
  /// A moving widget's first press only arms it for two seconds, so that Tab and Enter by accident move
  /// nothing.
  [[nodiscard]] bool armed(std::string_view id, double now_s) const {
    return is(id) && now_s < armed_until_s_;
  }

 private:
  void step(const Registry& registry, int direction);
  void read_activation(const Registry& registry, double now_s);

  std::string id_, entry_;
  bool visible_ = false, started_ = false, held_ = false, ended_ = false;
  bool entry_is_old_ = false;
  int frames_to_entry_ = 0;
  double armed_until_s_ = -1, pressed_at_s_ = 0;
};

}  // namespace hw::gui
