#pragma once
// The gamepad of this computer, as GLFW knows it, made into entries of the input queue. GLFW tells no events
// of one, and tells its state to windows without the focus too: so it is looked at 60 times a second while it
// is armed, and never otherwise. Window thread only.
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

/// What has changed between two looks.
class PadChanges {
 public:
  using Push = std::function<void(const InputEvent&)>;
  /// All of it changes with the first look.
  void forget() { before_ = PadState(); }
  /// None: it did not answer.
  void tell(const std::optional<PadState>& now, double now_s, const Push& push);

 private:
  PadState before_;
};

class GamepadSource {
 public:
  /// After glfwInit().
  void watch();
  /// Whether one was plugged in or pulled out since the last call; `push` hears of one that has gone.
  [[nodiscard]] bool has_news(double now_s, const PadChanges::Push& push);
  /// As its maker calls it; empty: none is there, or none that GLFW has a map of.
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
