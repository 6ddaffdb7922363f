#pragma once
// Which keys are down, and which of the events that come are presses of a hand. The window is told of presses
// and releases, but not of those that another window got meanwhile, or a grab took away (Alt+Tab, a
// screenshot): the X server is asked then. A key that was down already when the keyboard came is no press,
// however often it repeats, until it has been up. Window thread only.
#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace hw::gui {

class PhysicalKeys {
 public:
  using KeyMap = std::array<char, 32>;  ///< a bit for each key code of the X server
  /// The keys that are down for the server; none: the display has no such server.
  using Ask = std::function<std::optional<KeyMap>()>;
  explicit PhysicalKeys(Ask ask = ask_server) : ask_(std::move(ask)) {}

  /// Told of what the window system calls a press or an auto-repeat; `code` is the platform's own. True: a
  /// hand has pressed the key just now, and it counts as down.
  bool is_press(int key, int code, bool repeat);
  void release(int key, int code);
  /// Another window has the keyboard: what happens to the keys is not told.
  void forget();
  /// The keyboard is here again: whatever is down was pressed elsewhere.
  void come_back();
  /// Some key must be looked at from time to time: see lost().
  [[nodiscard]] bool any() const { return down_ > 0 || is_any(held_over_); }
  /// Those that nobody holds any more, although no release was told between this call and the one before.
  /// They are forgotten.
  [[nodiscard]] std::vector<int> lost();

 private:
  static std::optional<KeyMap> ask_server();
  static bool is_any(const KeyMap& keys);
  [[nodiscard]] bool is_known(int key) const { return key >= 0 && key < static_cast<int>(codes_.size()); }
  Ask ask_;
  std::array<int, 512> codes_{};      ///< by key; 0: it is up
  std::array<bool, 512> suspects_{};  ///< were up for the server, and their release may have been on its way
  std::array<bool, 512>
      seen_{};  ///< the server has shown them down: it does not of keys that a program sends
  KeyMap held_over_{};
  int down_ = 0;
  bool away_ = false;
};

}  // namespace hw::gui
