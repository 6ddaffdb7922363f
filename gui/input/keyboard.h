#pragma once
// The keyboard map, and the keys that are down. Keys that end a motion are handled on arrival: Esc stops
// everything even while the user types into a field, and a held jog ends when its key is released or the
// window loses the focus. Keys that begin an action wait for all earlier input. Auto-repeat triggers no
// action.
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "gui/input/input_queue.h"

namespace hw::gui {

enum class Command : std::uint8_t {
  stop_all,
  stop_at_once,  ///< follows stop_all
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
  jog_fourth_minus,  // only for the gamepad: no key
  jog_fourth_plus,
  jog_chosen_minus,  ///< the chosen axis
  jog_chosen_plus,
  count
};

/// Where a shortcut acts.
enum class Reach : std::uint8_t {
  always,        ///< even over a dialog
  also_typing,   ///< even while the user types; not behind an open dialog, menu or list
  outside_text,  ///< not while a text field, a list or a dialog uses the key
};

struct Shortcut {
  Command command;
  int key;  ///< GLFW key
  bool ctrl, shift;
  Reach reach;
  bool held;              ///< acts while the key is down
  std::string_view keys;  ///< as written in the map: "Ctrl Enter"
  std::string_view does;  ///< its effect, in words
};
/// The whole map, in the order in which the `?` page shows it.
std::span<const Shortcut> shortcuts();

struct CommandEdge {
  Command command;
  bool down;    ///< commands that are not held have only a down edge
  double at_s;  ///< time of the event, in seconds
  /// The edge comes from the gamepad, whose sticks have no taps.
  bool by_pad = false;
  /// The user did not end the hold, so an unfinished tap must move nothing. Only on release.
  bool cut_off = false;
};

class Keyboard {
 public:
  /// Called before the frame that shows the edge.
  std::function<void(const CommandEdge&)> on_edge;
  /// Called when the window loses the keyboard, before the held keys are released, so that a handler can
  /// distinguish this from a release by the user.
  std::function<void(double at_s)> on_focus_lost;

  /// Listeners for InputQueue. Return true when the event belongs to a shortcut, so that ImGui must not see
  /// it.
  bool on_arrival(const InputEvent& event);
  bool in_turn(const InputEvent& event);

  [[nodiscard]] bool held(Command c) const { return held_[index(c)]; }
  [[nodiscard]] bool jogging() const;
  /// Whether the key went down (or up) since the previous frame. For drawing code.
  [[nodiscard]] bool pressed(Command c) const { return now_.pressed[index(c)]; }
  [[nodiscard]] bool released(Command c) const { return now_.released[index(c)]; }

  /// Called by the frame: the user types, or a list or dialog uses the arrow keys.
  void set_typing(bool typing);
  [[nodiscard]] bool typing() const { return typing_; }
  /// Called by the frame: a dialog, a menu or a list covers the targets of most shortcuts.
  void set_covered(bool covered);
  [[nodiscard]] bool covered() const { return covered_; }
  /// Releases all held keys, as the loss of the focus does.
  void release_all(double at_s);
  /// Call between frames. Makes the edges since the previous call available to pressed() and released().
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
  std::array<bool, 512> taken_{};  // keys whose release belongs to a shortcut
  Edges now_, next_;
  Modifiers arrived_;    ///< from all arrived events, for keys that end a motion
  Modifiers modifiers_;  ///< from the events that had their turn
  bool typing_ = false, covered_ = false;
};

}  // namespace hw::gui
