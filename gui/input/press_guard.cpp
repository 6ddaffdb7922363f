#include "gui/input/press_guard.h"

#include <algorithm>

namespace hw::gui {
namespace {

bool same(const Rect& a, const Rect& b) {
  return a.min.x == b.min.x && a.min.y == b.min.y && a.max.x == b.max.x && a.max.y == b.max.y;
}

}  // namespace

PressGuard::Button& PressGuard::see(ImGuiID id, const Rect& rect, bool ready, double now_s) {
  auto button = std::find_if(buttons_.begin(), buttons_.end(), [&](const Button& p) { return p.id == id; });
  const bool is_new = button == buttons_.end();
  if (is_new) button = buttons_.insert(buttons_.end(), Button{.id = id});
  const bool moved = is_new || !same(button->rect, rect), woke = ready && !button->ready;
  if (moved || woke || !ready) button->since_s = now_s;
  if (moved || woke) button->became_ready = !moved;
  button->rect = rect;
  button->ready = ready;
  button->seen = true;
  return *button;
}

void PressGuard::end_frame() {
  std::erase_if(buttons_, [](const Button& p) { return !p.seen; });
  for (Button& p : buttons_) p.seen = false;
}

}  // namespace hw::gui
