#pragma once
// The gamepad as an input device. Turns its entries in the input queue into jog commands, as keys do, so that
// a jog by gamepad ends as a held key does. It acts while armed, and jogs while its dead-man button is held:
// only the axis with the largest stick deflection. The speed slider sets the speed, because no controller
// changes the speed of a jog as quickly as a stick moves. Events that end a motion are handled on arrival,
// events that begin a motion in turn.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gui/input/keyboard.h"

namespace hw::gui {

class Gamepad {
 public:
  /// Reports its commands through the keyboard.
  explicit Gamepad(Keyboard& keyboard) : keyboard_(keyboard) {}

  /// Call when a gamepad was plugged in, or has replaced another.
  void came(std::string name) { name_ = std::move(name); }
  [[nodiscard]] bool present() const { return !name_.empty(); }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// Starts polling, until the gamepad is disarmed. A control that is held already acts only after it was
  /// released.
  void arm(double now_s);
  void disarm(double now_s) { disarm({}, now_s); }
  [[nodiscard]] bool armed() const { return armed_; }
  /// Whether the gamepad holds a jog.
  [[nodiscard]] bool holds() const { return held_.has_value(); }
  /// Call when the hold was ended by other means. No jog begins before sticks and D-pad were released.
  void rest_first();

  /// Listeners for InputQueue. Return true when the event needs no further handling.
  bool on_arrival(const InputEvent& event);
  bool in_turn(const InputEvent& event);
  /// Ends the hold when the gamepad no longer answers.
  void begin_frame(double now_s);
  /// Returns, once, why the gamepad was disarmed; empty: it was not.
  [[nodiscard]] std::string take_words();

  static constexpr float begins_at = 0.6f, ends_at = 0.35f;  ///< of a stick's full deflection
  static constexpr float stronger_by = 0.2f;                 ///< lead that the other axis needs to take over
  static constexpr double silent_after_s = 0.2;  ///< a held jog ends after this time without a reply
  /// A held jog ends after this time without any change, because a gamepad out of radio reach keeps its last
  /// state. A held stick always changes within this time: even at its end stop it trembles across.
  static constexpr double same_for_s = 2;

 private:
  bool poll_pad(double at_s);
  void stop_if_unchanged(double at_s);
  void end(double at_s, bool cut_off);
  void stop(double at_s);
  void disarm(std::string_view why, double now_s);
  [[nodiscard]] std::optional<Command> pushed() const;
  [[nodiscard]] std::optional<Command> of_sticks() const;
  [[nodiscard]] bool let_go() const;

  Keyboard& keyboard_;
  std::string name_, words_;
  std::array<float, 4> sticks_{};  ///< as arrived, by GLFW's numbers
  std::array<bool, 16> buttons_{};
  std::optional<Command> held_;
  bool armed_ = false, must_rest_ = false;
  double answered_at_s_ = 0, changed_at_s_ = 0;
};

struct PadControl {
  std::string_view control, does;
};
/// The control list shown in the help.
std::span<const PadControl> gamepad_map();

}  // namespace hw::gui
