#pragma once
// The gamepad as one more input device: turns its entries in the input queue into edges of jog commands, as
// from keys, so that whatever ends a held jog ends these too. It acts while armed, and jogs while its
// dead-man button is held: one axis, the one with the largest stick deflection. A stick is on or off, as no
// controller changes a jog's speed as quickly as a stick moves: the speed slider sets the speed. Events that
// end something are handled on arrival, those that begin something in turn.
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

  /// A gamepad was plugged in, or has replaced one that is gone.
  void came(std::string name) { name_ = std::move(name); }
  [[nodiscard]] bool present() const { return !name_.empty(); }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// Starts polling, until it is disarmed. A control held already counts once it has been released.
  void arm(double now_s);
  void disarm(double now_s) { disarm({}, now_s); }
  [[nodiscard]] bool armed() const { return armed_; }
  /// Returns whether it holds a jog.
  [[nodiscard]] bool holds() const { return held_.has_value(); }
  /// Something else has ended its hold: nothing begins before sticks and D-pad have been released.
  void rest_first();

  /// For InputQueue's listeners: true when the event is fully handled.
  bool on_arrival(const InputEvent& event);
  bool in_turn(const InputEvent& event);
  /// Checks for silence.
  void begin_frame(double now_s);
  /// Why it was disarmed, reported once; empty: not disarmed.
  [[nodiscard]] std::string take_words();

  static constexpr float begins_at = 0.6f, ends_at = 0.35f;  ///< of a stick's full deflection
  static constexpr float stronger_by = 0.2f;                 ///< lead needed to switch to the other axis
  static constexpr double silent_after_s = 0.2;              ///< no reply while it holds a jog
  /// Longest time without any change while it holds a jog: a gamepad out of reach keeps its last state. A
  /// stick that is held is never this still: even at the end of one direction, the other trembles.
  static constexpr double same_for_s = 2;

 private:
  bool poll_pad(double at_s);
  void stop_if_left_alone(double at_s);
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
