#include "gui/physical_keys.h"

#include <optional>
#include <utility>

#include <dlfcn.h>

namespace hw::gui {
namespace {

using KeyMap = std::array<char, 32>;  // a bit for each key code of the X server

/// None: the display is no X server. Its headers are not needed to build.
std::optional<KeyMap> ask_server() {
  using GetDisplay = void* (*)();
  using QueryKeymap = int (*)(void*, char*);
  static const auto get_display = reinterpret_cast<GetDisplay>(dlsym(RTLD_DEFAULT, "glfwGetX11Display"));
  static const auto query = reinterpret_cast<QueryKeymap>(dlsym(RTLD_DEFAULT, "XQueryKeymap"));
  void* const display = get_display && query ? get_display() : nullptr;
  if (!display) return std::nullopt;
  KeyMap keys{};
  query(display, keys.data());
  return keys;
}

bool is_down(const KeyMap& keys, int code) {
  const auto byte = static_cast<std::size_t>(code / 8);
  return byte >= keys.size() || (static_cast<unsigned char>(keys[byte]) >> (code % 8) & 1) != 0;
}

}  // namespace

void PhysicalKeys::press(int key, int code) {
  if (!is_known(key) || code <= 0) return;
  if (codes_[static_cast<std::size_t>(key)] == 0) ++down_;
  codes_[static_cast<std::size_t>(key)] = code;
}

bool PhysicalKeys::is_press(int key, int code) {
  if (!is_known(key) || code <= 0 || codes_[static_cast<std::size_t>(key)] != 0) return false;
  const auto keys = ask_server();  // a repeat that was under way when the key came up is none
  if (!keys || !is_down(*keys, code)) return false;
  press(key, code);
  return true;
}

void PhysicalKeys::release(int key) {
  if (!is_known(key) || codes_[static_cast<std::size_t>(key)] == 0) return;
  codes_[static_cast<std::size_t>(key)] = 0;
  suspects_[static_cast<std::size_t>(key)] = seen_[static_cast<std::size_t>(key)] = false;
  --down_;
}

void PhysicalKeys::forget() {
  codes_.fill(0);
  suspects_.fill(false);
  seen_.fill(false);
  down_ = 0;
}

std::vector<int> PhysicalKeys::lost() {
  std::vector<int> keys;
  if (down_ == 0) return keys;
  const auto map = ask_server();
  if (!map) return keys;
  for (int key = 0; key < static_cast<int>(codes_.size()); ++key)
    if (const auto k = static_cast<std::size_t>(key); codes_[k] != 0) {
      const bool up = !is_down(*map, codes_[k]);
      seen_[k] = seen_[k] || !up;
      if (!seen_[k] || !std::exchange(suspects_[k], up) || !up) continue;
      keys.push_back(key);
      release(key);
    }
  return keys;
}

}  // namespace hw::gui
