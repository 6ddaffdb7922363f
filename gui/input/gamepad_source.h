#pragma once
// Turns the gamepad of this computer, as GLFW knows it, into entries of the input queue. GLFW has no gamepad
// events, and reports its state to windows without the focus too: so it is polled 60 times a second while
// armed, and never otherwise. Window thread only.
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "gui/input/input_queue.h"

namespace hw::gui {

struct PadState {
  std::array<float, 6> axes{};
  std::array<bool, 15> buttons{};
};

/// The changes between two polls.
class PadChanges {
 public:
  using Push = std::function<void(const InputEvent&)>;
  /// Makes the next poll report everything.
  void forget() { before_ = PadState(); }
  /// None: no reply.
  void report(const std::optional<PadState>& now, double now_s, const Push& push);

 private:
  PadState before_;
};

class GamepadSource {
 public:
  /// After glfwInit().
  void watch();
  /// Returns whether one was plugged in or removed since the last call; reports a removal to `push`.
  [[nodiscard]] bool has_news(double now_s, const PadChanges::Push& push);
  /// The maker's name; empty: no gamepad, or none that GLFW has a map of.
  [[nodiscard]] std::string name() const;
  void look_if_due(double now_s, const PadChanges::Push& push);
  void rest() { changes_.forget(); }
  [[nodiscard]] double due_in_s(double now_s) const { return looked_at_s_ + every_s - now_s; }

 private:
  static constexpr double every_s = 1.0 / 60;
  static constexpr int none = -1;
  int number_ = none;
  double looked_at_s_ = 0;
  PadChanges changes_;
};

}  // namespace hw::gui
