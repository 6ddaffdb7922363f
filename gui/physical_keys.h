#pragma once
// Which keys are down. The window is told of presses and releases, but who grabs the keyboard for a while
// (Alt+Tab, a screenshot) takes releases away, and a jog would go on: the X server is asked then. Window
// thread only.
#include <array>
#include <vector>

namespace hw::gui {

class PhysicalKeys {
 public:
  /// Told of a press; `code` is the platform's own.
  void press(int key, int code);
  /// Told of an auto-repeat: true if it is a press in truth, of a key whose release was taken away.
  bool is_press(int key, int code);
  void release(int key);
  void forget();
  [[nodiscard]] bool any() const { return down_ > 0; }
  /// Those that nobody holds any more, although no release was told between this call and the one before.
  /// They are forgotten.
  [[nodiscard]] std::vector<int> lost();

 private:
  [[nodiscard]] bool is_known(int key) const { return key >= 0 && key < static_cast<int>(codes_.size()); }
  std::array<int, 512> codes_{};      ///< by key; 0: it is up
  std::array<bool, 512> suspects_{};  ///< were up for the server, and their release may have been on its way
  std::array<bool, 512>
      seen_{};  ///< the server has shown them down: it does not of keys that a program sends
  int down_ = 0;
};

}  // namespace hw::gui
