#include "gui/input/physical_keys.h"

#include <algorithm>
#include <utility>

#include "gui/input/xlib.h"

namespace hw::gui {
namespace {

using KeyMap = PhysicalKeys::KeyMap;

bool is_down(const KeyMap& keys, int code) {
  const auto byte = static_cast<std::size_t>(code / 8);
  return byte < keys.size() && (static_cast<unsigned char>(keys[byte]) >> (code % 8) & 1) != 0;
}

void set_up(KeyMap& keys, int code) {
  const auto byte = static_cast<std::size_t>(code / 8);
  if (code > 0 && byte < keys.size()) keys[byte] = static_cast<char>(keys[byte] & ~(1 << code % 8));
}

}  // namespace

std::optional<KeyMap> PhysicalKeys::ask_server() {
  static const auto query = from_xlib<int (*)(void*, char*)>("XQueryKeymap");
  void* const display = query ? glfw_x_display() : nullptr;
  if (!display) return std::nullopt;
  KeyMap keys{};
  query(display, keys.data());
  return keys;
}

bool PhysicalKeys::is_any(const KeyMap& keys) {
  return std::any_of(keys.begin(), keys.end(), [](char byte) { return byte != 0; });
}

bool PhysicalKeys::is_press(int key, int code, bool repeat) {
  if (!is_known(key) || code <= 0) return !repeat;
  if (is_down(held_before_, code)) return false;
  int& known = codes_[static_cast<std::size_t>(key)];
  if (repeat) {
    // A repeat of a key that counts as up is a new press: the release before it was not reported. The key
    // must still be down, because a repeat may arrive late.
    if (known != 0 || away_) return false;
    const auto keys = ask_();
    if (!keys || !is_down(*keys, code)) return false;
  }
  if (std::exchange(known, code) == 0) ++down_;
  return true;
}

void PhysicalKeys::release(int key, int code) {
  set_up(held_before_, code);
  if (!is_known(key) || codes_[static_cast<std::size_t>(key)] == 0) return;
  codes_[static_cast<std::size_t>(key)] = 0;
  unconfirmed_[static_cast<std::size_t>(key)] = seen_[static_cast<std::size_t>(key)] = false;
  --down_;
}

void PhysicalKeys::forget() {
  codes_.fill(0);
  unconfirmed_.fill(false);
  seen_.fill(false);
  held_before_.fill(0);
  down_ = 0;
  away_ = true;
}

void PhysicalKeys::come_back() {
  forget();
  away_ = false;
  if (const auto keys = ask_()) held_before_ = *keys;
}

std::vector<int> PhysicalKeys::lost() {
  std::vector<int> keys;
  if (!any()) return keys;
  const auto map = ask_();
  if (!map) return keys;
  for (std::size_t i = 0; i < held_before_.size(); ++i)
    held_before_[i] = static_cast<char>(held_before_[i] & (*map)[i]);
  for (int key = 0; key < static_cast<int>(codes_.size()); ++key)
    if (const auto k = static_cast<std::size_t>(key); codes_[k] != 0) {
      const bool up = !is_down(*map, codes_[k]);
      seen_[k] = seen_[k] || !up;
      if (!seen_[k] || !std::exchange(unconfirmed_[k], up) || !up) continue;
      keys.push_back(key);
      release(key, codes_[k]);
    }
  return keys;
}

}  // namespace hw::gui
