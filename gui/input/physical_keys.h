#pragma once
// The keys that are down, and a test whether an event is a press by the user. Presses and releases that
// another window received, or a grab took away (Alt+Tab, a screenshot), are not reported to the window: the X
// server is then asked. A key that was already down when the keyboard came is no press, however often it
// repeats, until it has been up. Window thread only.
// however often it repeats, until it has been up. Window thread only.
#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace hw::gui {

class PhysicalKeys {
 public:
  using KeyMap = std::array<char, 32>;  ///< a bit for each key code of the X server
  /// The keys that are down for the server; none: no X server.
  using Ask = std::function<std::optional<KeyMap>()>;
  explicit PhysicalKeys(Ask ask = ask_server) : ask_(std::move(ask)) {}

  /// Handles a press or auto-repeat reported by the window system; `code` is the platform's own. True: the
  /// user has pressed the key just now, and it counts as down.
  bool is_press(int key, int code, bool repeat);
  void release(int key, int code);
  /// Another window has the keyboard: key events are not reported.
  void forget();
  /// The keyboard has come back: keys that are down were pressed elsewhere.
  void come_back();
  /// Returns whether some key must be checked from time to time: see lost().
  [[nodiscard]] bool any() const { return down_ > 0 || is_any(held_over_); }
  /// The keys that are no longer held although no release was reported since the previous call. They are
  /// forgotten.
  [[nodiscard]] std::vector<int> lost();

 private:
  static std::optional<KeyMap> ask_server();
  static bool is_any(const KeyMap& keys);
  [[nodiscard]] bool is_known(int key) const { return key >= 0 && key < static_cast<int>(codes_.size()); }
  Ask ask_;
  std::array<int, 512> codes_{};      ///< by key; 0: up
  std::array<bool, 512> suspects_{};  ///< were up for the server, with a release perhaps on its way
  std::array<bool, 512>
      seen_{};  ///< the server has shown them down, as it never does for keys that a program sends
  KeyMap held_over_{};
  int down_ = 0;
  bool away_ = false;
};

}  // namespace hw::gui
