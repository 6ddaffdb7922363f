#pragma once
// Everything a hand does, in order, between the window's callbacks (or a script) and ImGui. ImGui 1.86 looks
// at keys and buttons once per frame and so loses a tap that goes down and up in between; here each edge
// waits for a frame of its own. Shortcuts take their turn too: Ctrl+Enter after a digit runs the text with
// the digit. Only what ends something (Esc, letting go of a jog, losing the keyboard) is heard on arrival.
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include <imgui.h>

namespace hw::gui {

enum class InputKind : std::uint8_t {
  mouse_move,    ///< x, y in pixels
  mouse_button,  ///< code 0 left, 1 right, 2 middle; down; x, y: where. It counts there, wherever moves have
                 ///< led
  wheel,         ///< x, y in notches
  key,           ///< code: a GLFW key; down. Auto-repeat is not an event
  text,          ///< code: a Unicode code point
  focus_lost,    ///< all that is held is let go
  pad_stick,     ///< code: a GLFW gamepad axis; x: where it stands, -1 to 1
  pad_button,    ///< code: a GLFW gamepad button; down
  pad_heard,     ///< the end of what one look at the gamepad has told: it is there, and it answers
  pad_gone,      ///< it was unplugged
};

struct InputEvent;

/// Keys that change what another one means.
struct Modifiers {
  bool ctrl = false, shift = false, alt = false, super = false;
  /// As they are once this has happened.
  void follow(const InputEvent& event);
};

struct InputEvent {
  InputKind kind = InputKind::mouse_move;
  bool down = false;
  int code = 0;
  float x = 0, y = 0;
  double at_s = 0;  ///< when it happened, on the clock of the frames
  /// What the window system says is held with it, also what went down or up while another window had the
  /// keyboard; none: as the keys before it.
  std::optional<Modifiers> modifiers;

  [[nodiscard]] InputEvent with(Modifiers held) const;
  static InputEvent mouse_move(float x, float y, double at_s);
  static InputEvent mouse_button(int button, bool down, ImVec2 at, double at_s);
  static InputEvent wheel(float x, float y, double at_s);
  static InputEvent key(int glfw_key, bool down, double at_s);
  static InputEvent text(unsigned code_point, double at_s);
  static InputEvent focus_lost(double at_s);
  static InputEvent pad_stick(int glfw_axis, float place, double at_s);
  static InputEvent pad_button(int glfw_button, bool down, double at_s);
  static InputEvent pad_heard(double at_s);
  static InputEvent pad_gone(double at_s);
};

class InputQueue {
 public:
  /// Shown an event; true: taken, ImGui does not get it.
  using Listener = std::function<bool(const InputEvent&)>;
  /// `on_arrival` is shown each event as it comes, `in_turn` what is left when all before it has had its
  /// frame.
  void set_listeners(Listener on_arrival, Listener in_turn) {
    on_arrival_ = std::move(on_arrival);
    in_turn_ = std::move(in_turn);
  }

  /// Esc, the gamepad's B and the loss of the keyboard overtake: presses that still wait are dropped, so that
  /// nothing begins after a stop that came later. Typed text stays.
  void push(const InputEvent& event);
  /// Moves one frame's worth into ImGui, in order. True: more is waiting, so another frame should follow at
  /// once. `keys_wait`: the keyboard is on its way to a field; keys and text stay until it is there.
  bool feed(ImGuiIO& io, bool keys_wait = false);
  [[nodiscard]] bool empty() const { return waiting_.empty(); }
  /// Where the pointer is, by the newest event.
  [[nodiscard]] ImVec2 pointer() const { return pointer_; }
  /// When the newest press and release of the left button that ImGui has seen happened: how long a hand held.
  [[nodiscard]] double pressed_at_s() const { return pressed_at_s_; }
  [[nodiscard]] double released_at_s() const { return released_at_s_; }

 private:
  struct Fed {  // what this frame has had so far
    bool button = false, edit_key = false, text = false;
  };
  [[nodiscard]] bool fits(const InputEvent& event, const Fed& fed) const;
  void apply(const InputEvent& event, Fed& fed, ImGuiIO& io);
  void drop_presses();

  Listener on_arrival_, in_turn_;
  std::deque<InputEvent> waiting_;
  Modifiers modifiers_;
  ImVec2 pointer_;
  double pressed_at_s_ = 0, released_at_s_ = 0;
};

/// Tells ImGui which GLFW key is which; Tab and Escape are ours.
void map_keys(ImGuiIO& io);

}  // namespace hw::gui
