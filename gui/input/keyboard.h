#pragma once
// The keyboard map as data, and the keys that act. Keys that end something are handled on arrival: Esc stops
// everything even while a field is being typed into, and a held jog ends the moment its key is released or
// the window loses the focus. Keys that begin something wait for all earlier input. Auto-repeat never
// triggers anything again.
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
  jog_fourth_minus,  // no keys: for the gamepad
  jog_fourth_plus,
  jog_chosen_minus,  ///< the chosen axis
  jog_chosen_plus,
  count
};

/// Where a shortcut acts.
enum class Reach : std::uint8_t {
  always,        ///< also over a dialog
  also_typing,   ///< while text is being typed; not behind an open dialog, menu or list
  outside_text,  ///< not while a text field, a list or a dialog uses the key
};

struct Shortcut {
  Command command;
  int key;  ///< GLFW key
  bool ctrl, shift;
  Reach reach;
  bool held;              ///< acts while it is down
  std::string_view keys;  ///< as written in the map: "Ctrl Enter"
  std::string_view does;  ///< what it does, in words
};
/// The whole map, in the order in which the `?` page shows it.
std::span<const Shortcut> shortcuts();

struct CommandEdge {
  Command command;
  bool down;    ///< commands that are not held have a down edge only
  double at_s;  ///< when the key moved
  /// From the gamepad, whose sticks jog and have no taps.
  bool by_pad = false;
  /// On release: the hold was taken away, not released, so an unfinished tap moves nothing.
  bool cut_off = false;
};

class Keyboard {
 public:
  /// Called before the frame that shows the edge.
  std::function<void(const CommandEdge&)> on_edge;
  /// The window lost the keyboard. Called before the held keys are released, so that a handler can tell this
  /// from a release by the user.
  std::function<void(double at_s)> on_focus_lost;

  /// For InputQueue's listeners: true when the event belongs to a shortcut, so that ImGui must not see it.
  bool on_arrival(const InputEvent& event);
  bool in_turn(const InputEvent& event);

  [[nodiscard]] bool held(Command c) const { return held_[index(c)]; }
  [[nodiscard]] bool jogging() const;
  /// Whether its key went down (or up) since the previous frame. For drawing code.
  [[nodiscard]] bool pressed(Command c) const { return now_.pressed[index(c)]; }
  [[nodiscard]] bool released(Command c) const { return now_.released[index(c)]; }

  /// Set by the frame: the user is typing, or a list or dialog uses the arrows.
  void set_typing(bool typing);
  [[nodiscard]] bool typing() const { return typing_; }
  /// Set by the frame: a dialog, a menu or a list covers the targets of most shortcuts.
  void set_covered(bool covered);
  [[nodiscard]] bool covered() const { return covered_; }
  /// Releases all held keys, as when the window loses the focus.
  void release_all(double at_s);
  /// Between frames: makes the edges since then available to pressed() and released().
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
  Modifiers arrived_;    ///< by arrived events: for those that end something
  Modifiers modifiers_;  ///< by events that had their turn
  bool typing_ = false, covered_ = false;
};

}  // namespace hw::gui
