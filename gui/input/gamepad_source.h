#pragma once
// Turns the state of this computer's gamepad into entries of the input queue. GLFW has no gamepad events, so
// the gamepad is polled, 60 times a second. It is polled only while armed, because GLFW reports its state
// even when the window does not have the focus. Window thread only.
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
  /// Pushes the changes since the previous poll. nullopt: the gamepad did not reply.
  void report(const std::optional<PadState>& now, double now_s, const Push& push);

 private:
  PadState before_;
};

class GamepadSource {
 public:
  /// Call after glfwInit().
  void watch();
  /// Whether a gamepad was plugged in or removed since the last call. Reports a removal to `push`.
  [[nodiscard]] bool has_news(double now_s, const PadChanges::Push& push);
  /// The maker's name; empty: there is no gamepad that GLFW knows.
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
