#pragma once
// Another program that shows a menu, switches windows or locks the screen grabs the keyboard: it is then lost
// as with the focus, but GLFW does not report it. Detected on a separate connection to the X server; not on
// other displays. Window thread only.
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
  /// Events since the last call, in order; true: the keyboard was grabbed, false: it was given back.
  [[nodiscard]] std::vector<bool> take_news();
  /// Returns whether the newest event gave the keyboard back.
  [[nodiscard]] bool is_given_back();

 private:
  void read();
  void* display_ = nullptr;
  std::vector<bool> news_;
};

}  // namespace hw::gui
