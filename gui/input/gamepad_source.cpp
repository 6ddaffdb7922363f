#include "gui/input/gamepad_source.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <utility>

#include <GLFW/glfw3.h>

namespace hw::gui {
namespace {

/// Global, because GLFW's callback has no user data.
struct Plugging {
  bool news = true;
  unsigned went = 0;  ///< bit n: gamepad n was unplugged
} plugging;

void on_plugging(int number, int event) {
  plugging.news = true;
  if (event == GLFW_DISCONNECTED) plugging.went |= 1u << number;
}

int first_gamepad() {
  for (int number = GLFW_JOYSTICK_1; number <= GLFW_JOYSTICK_LAST; ++number)
    if (glfwJoystickIsGamepad(number)) return number;
  return -1;
}

std::optional<PadState> pad_state(int number) {
  GLFWgamepadstate from_glfw;
  if (number < 0 || !glfwGetGamepadState(number, &from_glfw)) return std::nullopt;
  PadState state;
  std::copy(std::begin(from_glfw.axes), std::end(from_glfw.axes), state.axes.begin());
  std::transform(std::begin(from_glfw.buttons), std::end(from_glfw.buttons), state.buttons.begin(),
                 [](unsigned char button) { return button == GLFW_PRESS; });
  return state;
}

}  // namespace

void PadChanges::report(const std::optional<PadState>& now, double now_s, const Push& push) {
  if (!now) return push(InputEvent::pad_gone(now_s));
  for (std::size_t i = 0; i < now->axes.size(); ++i)
    if (now->axes[i] != before_.axes[i])
      push(InputEvent::pad_stick(static_cast<int>(i), now->axes[i], now_s));
  for (std::size_t i = 0; i < now->buttons.size(); ++i)
    if (now->buttons[i] != before_.buttons[i])
      push(InputEvent::pad_button(static_cast<int>(i), now->buttons[i], now_s));
  before_ = *now;
  push(InputEvent::pad_polled(now_s));
}

void GamepadSource::watch() { glfwSetJoystickCallback(on_plugging); }

bool GamepadSource::has_news(double now_s, const PadChanges::Push& push) {
  if (!std::exchange(plugging.news, false)) return false;
  const unsigned went = std::exchange(plugging.went, 0);
  const bool mine_went = number_ != none && (went >> number_ & 1u) != 0;
  if (number_ != none && !mine_went)
    return false;  // another gamepad was unplugged; the present one stays in use
  if (mine_went) push(InputEvent::pad_gone(now_s));
  number_ = first_gamepad();
  return mine_went || number_ != none;
}

std::string GamepadSource::name() const {
  const char* name = number_ == none ? nullptr : glfwGetGamepadName(number_);
  return name ? name : "";
}

void GamepadSource::look_if_due(double now_s, const PadChanges::Push& push) {
  if (due_in_s(now_s) > 0) return;
  looked_at_s_ = now_s;
  changes_.report(pad_state(number_), now_s, push);
}

}  // namespace hw::gui
