#pragma once
// Tracks the keys that are down, and decides whether an event is a press by the user. The window is not told
// of presses and releases that another window received, or that a grab took away (Alt+Tab, a screenshot), so
// the X server is asked. A key that was down when the window got the keyboard counts as pressed only after it
// was released, however often it repeats. Window thread only.
#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace hw::gui {

class PhysicalKeys {
 public:
  using KeyMap = std::array<char, 32>;  ///< one bit for each key code of the X server
  /// The keys that are down according to the X server; nullopt: there is no X server.
  using Ask = std::function<std::optional<KeyMap>()>;
  explicit PhysicalKeys(Ask ask = ask_server) : ask_(std::move(ask)) {}

  /// Handles a press or auto-repeat reported by the window system; `code` is the platform's own. Returns true
  /// when the user has pressed the key just now; it then counts as down.
  bool is_press(int key, int code, bool repeat);
  void release(int key, int code);
  /// Call when another window gets the keyboard. Key events are not reported from then on.
  void forget();
  /// Call when the window gets the keyboard back. Keys that are down now were pressed elsewhere.
  void come_back();
  /// Whether lost() must be called from time to time.
  [[nodiscard]] bool any() const { return down_ > 0 || is_any(held_before_); }
  /// Returns and forgets the keys that are no longer held although no release was reported.
  [[nodiscard]] std::vector<int> lost();

 private:
  static std::optional<KeyMap> ask_server();
  static bool is_any(const KeyMap& keys);
  [[nodiscard]] bool is_known(int key) const { return key >= 0 && key < static_cast<int>(codes_.size()); }
  Ask ask_;
  std::array<int, 512> codes_{};         ///< by key; 0: up
  std::array<bool, 512> unconfirmed_{};  ///< up according to the server; their release may still arrive
  std::array<bool, 512>
      seen_{};  ///< down according to the server, which does not know keys sent by a program
  KeyMap held_before_{};
  int down_ = 0;
  bool away_ = false;
};

}  // namespace hw::gui
