#pragma once
// Detects that another program grabs the keyboard, to show a menu, switch windows or lock the screen. The
// window then receives no keys, as without the focus, but GLFW does not report it. Uses a connection of its
// own to the X server; does nothing on other displays. Window thread only.
#include <vector>

struct GLFWwindow;

namespace hw::gui {

class KeyboardGrabs {
 public:
  KeyboardGrabs() = default;
  ~KeyboardGrabs();
  KeyboardGrabs(const KeyboardGrabs&) = delete;
  KeyboardGrabs& operator=(const KeyboardGrabs&) = delete;

  void watch(GLFWwindow* window);
  /// The events since the last call, in order. true: the keyboard was grabbed; false: it was returned.
  [[nodiscard]] std::vector<bool> take_news();
  /// Whether the keyboard was returned by the newest event.
  [[nodiscard]] bool is_given_back();

 private:
  void read();
  void* display_ = nullptr;
  std::vector<bool> news_;
};

}  // namespace hw::gui
