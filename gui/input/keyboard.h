#pragma once
// The map of the keyboard as data, and the keys that act. What ends something is seen on arrival: Esc stops
// everything even while a field is being typed into, and a held jog key is let go the moment it is released
// or the window loses the focus. What begins something waits for all that was typed before it. Auto-repeat
// never triggers anything again.
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "gui/input/input_queue.h"

namespace hw::gui {

enum class Command : std::uint8_t {
  stop_all,
  stop_at_once,  ///< comes behind stop_all
  run,
  simulate,
  save,
  open,
  next_controller,
  previous_controller,
  show_map,
  larger,
  smaller,
  normal_size,
  close_controller,
  jog_left,  // six jog keys in this order: see jog_keys
  jog_right,
  jog_up,
  jog_down,
  jog_page_up,
  jog_page_down,
  jog_fourth_minus,  // these have no key: the gamepad's
  jog_fourth_plus,
  jog_chosen_minus,  ///< the axis that is chosen
  jog_chosen_plus,
  count
};

/// Where a shortcut counts.
enum class Reach : std::uint8_t {
  always,        ///< also over a dialog
  also_typing,   ///< while text is being typed; not behind a dialog, a menu or a list that is open
  outside_text,  ///< not while a text field, a list or a dialog wants the key
};

struct Shortcut {
  Command command;
  int key;  ///< GLFW key
  bool ctrl, shift;
  Reach reach;
  bool held;              ///< acts as long as it is down
  std::string_view keys;  ///< as the map writes it: "Ctrl Enter"
  std::string_view does;  ///< what it does, in words
};
/// The whole map, in the order in which the `?` page shows it.
std::span<const Shortcut> shortcuts();

struct CommandEdge {
  Command command;
  bool down;    ///< commands that are not held have a down edge only
  double at_s;  ///< when the key moved
  /// By the gamepad, whose sticks jog and have no taps.
  bool by_pad = false;
  /// Up: the hand was taken away. It has not let go, so what was a tap until now moves nothing.
  bool cut_off = false;
};

class Keyboard {
 public:
  /// Called before the frame that shows it.
  std::function<void(const CommandEdge&)> on_edge;
  /// The window lost the keyboard. Called before the held keys are released, so that whoever acts on a
  /// release can tell it from a hand that lets go.
  std::function<void(double at_s)> on_focus_lost;

  /// For InputQueue's listeners: true when the event is a shortcut's, so that ImGui must not see it.
  bool on_arrival(const InputEvent& event);
  bool in_turn(const InputEvent& event);

  [[nodiscard]] bool held(Command c) const { return held_[index(c)]; }
  [[nodiscard]] bool jogging() const;
  /// Whether its key went down (or up) since the frame before. For code that draws.
  [[nodiscard]] bool pressed(Command c) const { return now_.pressed[index(c)]; }
  [[nodiscard]] bool released(Command c) const { return now_.released[index(c)]; }

  /// Said by the frame: somebody types, or a list or dialog wants the arrows.
  void set_typing(bool typing);
  [[nodiscard]] bool typing() const { return typing_; }
  /// Said by the frame: a dialog, a menu or a list lies over what most shortcuts act on.
  void set_covered(bool covered);
  [[nodiscard]] bool covered() const { return covered_; }
  /// Lets go of all held keys, as when the window loses its focus.
  void release_all(double at_s);
  /// Frame border: what arrived since becomes what pressed() and released() tell.
  void begin_frame();

 private:
  static constexpr std::size_t n = static_cast<std::size_t>(Command::count);
  static constexpr std::size_t index(Command c) { return static_cast<std::size_t>(c); }
  struct Edges {
    std::array<bool, n> pressed{}, released{};
  };
  void emit(Command c, bool down, double at_s);
  const Shortcut* match(int key) const;
  bool stop_key(const InputEvent& event);
  bool key_down(const InputEvent& event);
  bool key_up(const InputEvent& event);

  std::array<bool, n> held_{};
  std::array<bool, 512> taken_{};  // keys whose release belongs to us
  Edges now_, next_;
  Modifiers arrived_;    ///< as far as events have arrived: of what ends something
  Modifiers modifiers_;  ///< as far as they have had their turn
  bool typing_ = false, covered_ = false;
};

}  // namespace hw::gui
