#include "gui/input/input_queue.h"

#define GLFW_INCLUDE_NONE
#include <cfloat>

#include <GLFW/glfw3.h>

namespace hw::gui {
namespace {

bool is_one_of(int key, int left, int right) { return key == left || key == right; }
bool is_shift(int key) { return is_one_of(key, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT); }
bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }
/// Whether a key only produces a text event. Neither ImGui nor a shortcut uses its press or release.
bool only_types(int key, const Modifiers& m) {
  return (key > GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2) && !m.ctrl && !m.alt && !m.super;
}

InputEvent make_event(InputKind kind, bool down, int code, float x, float y, double at_s) {
  InputEvent e;
  e.kind = kind;
  e.down = down;
  e.code = code;
  e.x = x;
  e.y = y;
  e.at_s = at_s;
  return e;
}

bool stops(const InputEvent& e) {
  return e.down && ((e.kind == InputKind::key && e.code == GLFW_KEY_ESCAPE) ||
                    (e.kind == InputKind::pad_button && e.code == GLFW_GAMEPAD_BUTTON_B));
}

}  // namespace

void Modifiers::follow(const InputEvent& event) {
  if (event.modifiers) *this = *event.modifiers;
  if (event.kind == InputKind::focus_lost) *this = {};
  if (event.kind != InputKind::key) return;
  // The window system reports the modifiers before the event, so the key itself is applied afterwards.
  if (is_one_of(event.code, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL)) ctrl = event.down;
  if (is_one_of(event.code, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT)) shift = event.down;
  if (is_one_of(event.code, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)) alt = event.down;
  if (is_one_of(event.code, GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER)) super = event.down;
}

InputEvent InputEvent::with(Modifiers held) const {
  InputEvent e = *this;
  e.modifiers = held;
  return e;
}
InputEvent InputEvent::mouse_move(float x, float y, double at_s) {
  return make_event(InputKind::mouse_move, false, 0, x, y, at_s);
}
InputEvent InputEvent::mouse_button(int button, bool down, ImVec2 at, double at_s) {
  return make_event(InputKind::mouse_button, down, button, at.x, at.y, at_s);
}
InputEvent InputEvent::wheel(float x, float y, double at_s) {
  return make_event(InputKind::wheel, false, 0, x, y, at_s);
}
InputEvent InputEvent::key(int glfw_key, bool down, double at_s) {
  return make_event(InputKind::key, down, glfw_key, 0, 0, at_s);
}
InputEvent InputEvent::text(unsigned code_point, double at_s) {
  return make_event(InputKind::text, false, static_cast<int>(code_point), 0, 0, at_s);
}
InputEvent InputEvent::focus_lost(double at_s) {
  return make_event(InputKind::focus_lost, false, 0, 0, 0, at_s);
}
InputEvent InputEvent::pad_stick(int glfw_axis, float place, double at_s) {
  return make_event(InputKind::pad_stick, false, glfw_axis, place, 0, at_s);
}
InputEvent InputEvent::pad_button(int glfw_button, bool down, double at_s) {
  return make_event(InputKind::pad_button, down, glfw_button, 0, 0, at_s);
}
InputEvent InputEvent::pad_polled(double at_s) {
  return make_event(InputKind::pad_polled, false, 0, 0, 0, at_s);
}
InputEvent InputEvent::pad_gone(double at_s) { return make_event(InputKind::pad_gone, false, 0, 0, 0, at_s); }

void InputQueue::push(const InputEvent& event) {
  if (stops(event) || event.kind == InputKind::focus_lost) drop_presses();
  if (event.kind == InputKind::mouse_move || event.kind == InputKind::mouse_button)
    pointer_ = ImVec2(event.x, event.y);
  if (on_arrival_ && on_arrival_(event)) return;
  // Consecutive mouse moves share one place in the queue.
  if (event.kind == InputKind::mouse_move && !waiting_.empty() &&
      waiting_.back().kind == InputKind::mouse_move)
    waiting_.back() = event;
  else
    waiting_.push_back(event);
}

void InputQueue::drop_presses() {
  std::erase_if(waiting_, [](const InputEvent& e) {
    return e.down &&
           (e.kind == InputKind::mouse_button || (e.kind == InputKind::key && !is_modifier(e.code)));
  });
}

bool InputQueue::fits(const InputEvent& event, const FedInFrame& fed) const {
  Modifiers held = modifiers_;
  held.follow(event);
  const bool untouched = !fed.edit_key && !fed.button;
  switch (event.kind) {
    case InputKind::mouse_move: return !fed.button;
    case InputKind::mouse_button: return untouched && !fed.text;
    case InputKind::wheel: return true;
    case InputKind::key:
      if (only_types(event.code, held) || is_shift(event.code)) return untouched;
      return untouched && !fed.text;
    case InputKind::text: return untouched;
    case InputKind::focus_lost: return untouched && !fed.text;
    case InputKind::pad_stick:
    case InputKind::pad_button:
    case InputKind::pad_polled:
    case InputKind::pad_gone: return true;
  }
  return true;
}

void InputQueue::apply(const InputEvent& event, FedInFrame& fed, ImGuiIO& io) {
  switch (event.kind) {
    case InputKind::mouse_move: io.MousePos = ImVec2(event.x, event.y); break;
    case InputKind::mouse_button:
      if (event.code < 0 || event.code >= 5) break;
      io.MousePos = ImVec2(event.x, event.y);
      io.MouseDown[event.code] = event.down;
      if (event.code == 0) (event.down ? pressed_at_s_ : released_at_s_) = event.at_s;
      fed.button = true;
      break;
    case InputKind::wheel:
      io.MouseWheelH += event.x;
      io.MouseWheel += event.y;
      break;
    case InputKind::key:
      if (event.code < 0 || event.code >= IM_ARRAYSIZE(io.KeysDown)) break;
      io.KeysDown[event.code] = event.down;
      key_moved_at_s_ = event.at_s;
      if (!only_types(event.code, modifiers_) && !is_shift(event.code)) fed.edit_key = true;
      break;
    case InputKind::text:
      io.AddInputCharacter(static_cast<unsigned>(event.code));
      fed.text = true;
      break;
    case InputKind::focus_lost:
      for (bool& down : io.KeysDown) down = false;
      for (bool& down : io.MouseDown) down = false;
      // The mouse leaves all widgets, so that the release does not count as a click on the pressed widget.
      io.MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
      released_at_s_ = key_moved_at_s_ = event.at_s;
      fed.button = true;
      break;
    case InputKind::pad_stick:  // ImGui does not handle the gamepad
    case InputKind::pad_button:
    case InputKind::pad_polled:
    case InputKind::pad_gone: break;
  }
}

bool InputQueue::feed(ImGuiIO& io, bool keys_wait) {
  FedInFrame fed;
  while (!waiting_.empty() && fits(waiting_.front(), fed)) {
    const InputEvent event = waiting_.front();
    if (keys_wait && (event.kind == InputKind::key || event.kind == InputKind::text)) break;
    waiting_.pop_front();
    modifiers_.follow(event);
    if (!in_turn_ || !in_turn_(event)) apply(event, fed, io);
  }
  io.KeyCtrl = modifiers_.ctrl;
  io.KeyShift = modifiers_.shift;
  io.KeyAlt = modifiers_.alt;
  io.KeySuper = modifiers_.super;
  return !waiting_.empty();
}

void map_keys(ImGuiIO& io) {
  for (int& key : io.KeyMap) key = -1;
  io.KeyMap[ImGuiKey_LeftArrow] = GLFW_KEY_LEFT;
  io.KeyMap[ImGuiKey_RightArrow] = GLFW_KEY_RIGHT;
  io.KeyMap[ImGuiKey_UpArrow] = GLFW_KEY_UP;
  io.KeyMap[ImGuiKey_DownArrow] = GLFW_KEY_DOWN;
  io.KeyMap[ImGuiKey_PageUp] = GLFW_KEY_PAGE_UP;
  io.KeyMap[ImGuiKey_PageDown] = GLFW_KEY_PAGE_DOWN;
  io.KeyMap[ImGuiKey_Home] = GLFW_KEY_HOME;
  io.KeyMap[ImGuiKey_End] = GLFW_KEY_END;
  io.KeyMap[ImGuiKey_Insert] = GLFW_KEY_INSERT;
  io.KeyMap[ImGuiKey_Delete] = GLFW_KEY_DELETE;
  io.KeyMap[ImGuiKey_Backspace] = GLFW_KEY_BACKSPACE;
  io.KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
  io.KeyMap[ImGuiKey_KeyPadEnter] = GLFW_KEY_KP_ENTER;
  io.KeyMap[ImGuiKey_A] = GLFW_KEY_A;
  io.KeyMap[ImGuiKey_C] = GLFW_KEY_C;
  io.KeyMap[ImGuiKey_V] = GLFW_KEY_V;
  io.KeyMap[ImGuiKey_X] = GLFW_KEY_X;
  io.KeyMap[ImGuiKey_Y] = GLFW_KEY_Y;
  io.KeyMap[ImGuiKey_Z] = GLFW_KEY_Z;
}

}  // namespace hw::gui
