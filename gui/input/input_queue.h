#pragma once
// Keeps all user input in order, between the window's callbacks (or a script) and ImGui. ImGui 1.86 reads
// keys and buttons once per frame and so loses a tap between two frames; here each edge gets a frame of its
// own. Shortcuts wait their turn too: Ctrl+Enter after a digit runs the text with the digit. Only input that
// ends a motion (Esc, releasing a jog, losing the keyboard) is handled on arrival.
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include <imgui.h>

namespace hw::gui {

enum class InputKind : std::uint8_t {
  mouse_move,    ///< x, y in pixels
  mouse_button,  ///< code 0 left, 1 right, 2 middle; down; x, y: place of the press, even if the pointer has
                 ///< moved
  wheel,         ///< x, y in notches
  key,           ///< code: a GLFW key; down. Auto-repeat makes no event
  text,          ///< code: a Unicode code point
  focus_lost,    ///< releases all held keys and buttons
  pad_stick,     ///< code: a GLFW gamepad axis; x: its position, -1 to 1
  pad_button,    ///< code: a GLFW gamepad button; down
  pad_polled,    ///< end of a poll: the gamepad has answered
  pad_gone,      ///< the gamepad was unplugged
};

struct InputEvent;

/// The modifier keys that are down.
struct Modifiers {
  bool ctrl = false, shift = false, alt = false, super = false;
  /// Updates them from this event.
  void follow(const InputEvent& event);
};

struct InputEvent {
  InputKind kind = InputKind::mouse_move;
  bool down = false;
  int code = 0;
  float x = 0, y = 0;
  double at_s = 0;  ///< time of the event in seconds, on the clock of the frames
  /// Modifiers at the event according to the window system, which knows of changes while another window had
  /// the keyboard. nullopt: take them from the earlier key events.
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
  static InputEvent pad_polled(double at_s);
  static InputEvent pad_gone(double at_s);
};

class InputQueue {
 public:
  /// Receives an event. Returns true when it was handled and is not for ImGui.
  using Listener = std::function<bool(const InputEvent&)>;
  /// `on_arrival` receives each event at once. `in_turn` receives the events that `on_arrival` did not
  /// handle, each after all earlier events have had their frame.
  void set_listeners(Listener on_arrival, Listener in_turn) {
    on_arrival_ = std::move(on_arrival);
    in_turn_ = std::move(in_turn);
  }

  /// Adds an event. Esc, B on the gamepad and the loss of the keyboard drop all waiting presses, so that no
  /// motion begins after a later stop. Typed text stays.
  void push(const InputEvent& event);
  /// Passes the events of one frame to ImGui, in order. Returns true when more events wait, so that another
  /// frame must follow at once. `keys_wait`: a field is about to get the keyboard, so keys and text wait for
  /// it.
  bool feed(ImGuiIO& io, bool keys_wait = false);
  [[nodiscard]] bool empty() const { return waiting_.empty(); }
  /// Position of the pointer in pixels, from the newest event.
  [[nodiscard]] ImVec2 pointer() const { return pointer_; }
  /// Times of the newest press and release of the left button that ImGui has seen.
  [[nodiscard]] double pressed_at_s() const { return pressed_at_s_; }
  [[nodiscard]] double released_at_s() const { return released_at_s_; }
  /// Time of the newest press or release of a key.
  [[nodiscard]] double key_moved_at_s() const { return key_moved_at_s_; }

 private:
  struct FedInFrame {  // events passed in this frame
    bool button = false, edit_key = false, text = false;
  };
  [[nodiscard]] bool fits(const InputEvent& event, const FedInFrame& fed) const;
  void apply(const InputEvent& event, FedInFrame& fed, ImGuiIO& io);
  void drop_presses();

  Listener on_arrival_, in_turn_;
  std::deque<InputEvent> waiting_;
  Modifiers modifiers_;
  ImVec2 pointer_;
  double pressed_at_s_ = 0, released_at_s_ = 0, key_moved_at_s_ = 0;
};

/// Maps GLFW keys for ImGui, except Tab and Escape, which the console handles.
void map_keys(ImGuiIO& io);

}  // namespace hw::gui
