#pragma once
// Who shows a menu, switches windows or locks the screen grabs the keyboard: it is lost then as with the
// focus, but GLFW does not tell. Heard on a connection of its own to the X server; on other displays nothing
// is. Window thread only.
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
  /// What happened since the last call, in order; true: somebody took the keyboard, false: gave it back.
  [[nodiscard]] std::vector<bool> take_news();
  /// The newest of it is that it was given back.
  [[nodiscard]] bool is_given_back();

 private:
  void read();
  void* display_ = nullptr;
  std::vector<bool> news_;
};

}  // namespace hw::gui
