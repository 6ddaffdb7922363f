#pragma once
// The gamepad as one more hand: from its entries in the input queue come the edges of jog commands, as from
// keys, so that all that ends a held jog ends these too. It acts while it is armed, and jogs while its
// dead-man button is held: one axis, the one that a stick is pushed to most. A stick is on or off, for no
// controller changes a jog's speed for as little as a stick's move takes: how fast is the speed slider's.
// What ends something is heard on arrival, what begins something waits its turn.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gui/input/keyboard.h"

namespace hw::gui {

class Gamepad {
 public:
  /// What it does is told where the keyboard tells it.
  explicit Gamepad(Keyboard& keyboard) : keyboard_(keyboard) {}

  /// One was plugged in, or stands for one that has gone.
  void came(std::string name) { name_ = std::move(name); }
  [[nodiscard]] bool present() const { return !name_.empty(); }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// From now on it is looked at, until something disarms it. What is held already counts when it has been
  /// let go once.
  void arm(double now_s);
  void disarm(double now_s) { disarm({}, now_s); }
  [[nodiscard]] bool armed() const { return armed_; }
  /// It holds a jog.
  [[nodiscard]] bool holds() const { return held_.has_value(); }
  /// Something else has ended what it held: nothing begins before sticks and D-pad have been let go.
  void rest_first();

  /// For InputQueue's listeners: true when nobody else need see the event.
  bool on_arrival(const InputEvent& event);
  bool in_turn(const InputEvent& event);
  /// Notices that nothing has been heard.
  void begin_frame(double now_s);
  /// Why it was disarmed, told once; empty: it was not.
  [[nodiscard]] std::string take_words();

  static constexpr float begins_at = 0.6f, ends_at = 0.35f;  ///< of a stick's way
  static constexpr float stronger_by = 0.2f;                 ///< what takes a stick's jog to its other axis
  static constexpr double silent_after_s = 0.2;              ///< no answer while it holds a jog
  /// While it holds one and nothing on it changes. No hand keeps a stick so still half way, but at its end a
  /// stick is as still as a button, with a hand on it or without.
  static constexpr double same_for_s = 5, same_at_end_for_s = 30;
  static constexpr float at_end = 0.98f;  ///< of a stick's way

 private:
  bool hear(double at_s);
  void end(double at_s, bool cut_off);
  void stop(double at_s);
  void disarm(std::string_view why, double now_s);
  [[nodiscard]] std::optional<Command> pushed() const;
  [[nodiscard]] std::optional<Command> of_sticks() const;
  [[nodiscard]] bool let_go() const;
  [[nodiscard]] double may_stay_same_s() const;

  Keyboard& keyboard_;
  std::string name_, words_;
  std::array<float, 4> sticks_{};  ///< as they have arrived, by GLFW's numbers
  std::array<bool, 16> buttons_{};
  std::optional<Command> held_;
  bool armed_ = false, must_rest_ = false;
  double heard_at_s_ = 0, changed_at_s_ = 0;
};

struct PadControl {
  std::string_view control, does;
};
/// What the help shows of it.
std::span<const PadControl> gamepad_map();

}  // namespace hw::gui
