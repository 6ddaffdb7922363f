#include "gui/input/focus.h"

#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>

namespace hw::gui {

void Focus::begin_frame(Registry& registry, Times times, bool typing, TabTaken taken) {
  started_ = ended_ = false;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(0)) visible_ = false;
  const bool back = io.KeyShift;
  const bool free = taken == TabTaken::no || (taken == TabTaken::forward && back);
  if (ImGui::IsKeyPressed(GLFW_KEY_TAB, true) && !io.KeyCtrl && free) {
    step(registry, back ? -1 : 1);
    if (!id_.empty()) registry.scroll_to(id_);
    return;
  }
  if (!typing) read_activation(registry, times);
}

void Focus::read_activation(const Registry& registry, Times times) {
  const bool pressed = ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) ||
                       ImGui::IsKeyPressed(GLFW_KEY_SPACE, false) ||
                       ImGui::IsKeyPressed(GLFW_KEY_KP_ENTER, false);
  const bool down = ImGui::IsKeyDown(GLFW_KEY_ENTER) || ImGui::IsKeyDown(GLFW_KEY_SPACE) ||
                    ImGui::IsKeyDown(GLFW_KEY_KP_ENTER);
  if (held_ && !down) {
    held_ = false;
    ended_ = true;
    released_at_s_ = times.key_moved_at_s;
  }
  if (!pressed || !visible_) return;
  const Widget* widget = registry.find(id_);
  if (!widget || !widget->enabled) return;
  if (widget->moving && times.now_s >= armed_until_s_) {
    armed_until_s_ = times.now_s + 2.0;
    return;
  }
  armed_until_s_ = -1;
  started_ = held_ = true;
  pressed_at_s_ = times.key_moved_at_s;
}

void Focus::step(const Registry& registry, int direction) {
  const auto widgets = registry.widgets();
  const int n = static_cast<int>(widgets.size());
  int at = direction > 0 ? -1 : n;
  for (int i = 0; i < n; ++i)
    if (is(widgets[static_cast<std::size_t>(i)].id)) at = i;
  for (int tried = 0; tried < n; ++tried) {
    at = (at + direction + n) % n;
    const Widget& w = widgets[static_cast<std::size_t>(at)];
    if (w.usable() && w.enabled && w.layer == registry.top_layer()) {
      move_to(w.id);
      return;
    }
  }
}

void Focus::set(std::string_view id) {
  if (!is(id)) id_ = id;
  visible_ = false;
  armed_until_s_ = -1;
}

void Focus::move_to(std::string_view id) {
  id_ = id;
  entry_ = id;
  entry_is_old_ = false;
  visible_ = true;
  held_ = false;
  armed_until_s_ = -1;
  if (ImGui::GetCurrentContext()) ImGui::ClearActiveID();  // ends typing in any field
}

bool Focus::take_entry(std::string_view id) {
  if (entry_.empty() || entry_ != id) return false;
  entry_.clear();
  frames_to_entry_ = 3;  // ImGui gives a field the keyboard a frame or two after the request
  return true;
}

void Focus::end_frame(bool typing) {
  frames_to_entry_ = typing ? 0 : std::max(frames_to_entry_ - 1, 0);
  if (entry_is_old_) entry_.clear();  // no field has that id; perhaps a button
  entry_is_old_ = !entry_.empty();
}

}  // namespace hw::gui
