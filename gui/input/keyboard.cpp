#include "gui/input/keyboard.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace hw::gui {
namespace {

constexpr bool ctrl = true, shift = true, plain = false;
constexpr int by_letter = -1;  // the key of `?` depends on the keyboard layout, so its text event counts
constexpr Shortcut table[] = {
    {Command::stop_all, GLFW_KEY_ESCAPE, plain, plain, Reach::always, false, "Esc",
     "Stop all controllers; again: at once"},
    {Command::stop_at_once, GLFW_KEY_ESCAPE, plain, shift, Reach::always, false, "Shift Esc",
     "Stop all at once, without a ramp"},
    {Command::jog_left, GLFW_KEY_LEFT, plain, plain, Reach::outside_text, true, "Left",
     "Jog axis 1 \u2212 while held"},
    {Command::jog_right, GLFW_KEY_RIGHT, plain, plain, Reach::outside_text, true, "Right",
     "Jog axis 1 + while held"},
    {Command::jog_down, GLFW_KEY_DOWN, plain, plain, Reach::outside_text, true, "Down",
     "Jog axis 2 \u2212 while held"},
    {Command::jog_up, GLFW_KEY_UP, plain, plain, Reach::outside_text, true, "Up", "Jog axis 2 + while held"},
    {Command::jog_page_down, GLFW_KEY_PAGE_DOWN, plain, plain, Reach::outside_text, true, "Page down",
     "Jog axis 3 \u2212 while held"},
    {Command::jog_page_up, GLFW_KEY_PAGE_UP, plain, plain, Reach::outside_text, true, "Page up",
     "Jog axis 3 + while held"},
    {Command::run, GLFW_KEY_ENTER, ctrl, plain, Reach::also_typing, false, "Ctrl Enter", "Run the program"},
    {Command::run, GLFW_KEY_KP_ENTER, ctrl, plain, Reach::also_typing, false, "", ""},
    {Command::simulate, GLFW_KEY_F5, plain, plain, Reach::also_typing, false, "F5", "Simulate the program"},
    {Command::save, GLFW_KEY_S, ctrl, plain, Reach::also_typing, false, "Ctrl S",
     "Save the text to its file"},
    {Command::open, GLFW_KEY_O, ctrl, plain, Reach::also_typing, false, "Ctrl O", "Open a file"},
    {Command::next_controller, GLFW_KEY_TAB, ctrl, plain, Reach::also_typing, false, "Ctrl Tab",
     "Next controller"},
    {Command::previous_controller, GLFW_KEY_TAB, ctrl, shift, Reach::also_typing, false, "Ctrl Shift Tab",
     "Previous controller"},
    {Command::close_controller, GLFW_KEY_W, ctrl, plain, Reach::always, false, "Ctrl W",
     "Close the controller"},
    {Command::larger, GLFW_KEY_EQUAL, ctrl, plain, Reach::always, false, "Ctrl +", "Everything larger"},
    {Command::larger, GLFW_KEY_EQUAL, ctrl, shift, Reach::always, false, "", ""},
    {Command::larger, GLFW_KEY_KP_ADD, ctrl, plain, Reach::always, false, "", ""},
    {Command::smaller, GLFW_KEY_MINUS, ctrl, plain, Reach::always, false, "Ctrl \u2212",
     "Everything smaller"},
    {Command::smaller, GLFW_KEY_KP_SUBTRACT, ctrl, plain, Reach::always, false, "", ""},
    {Command::normal_size, GLFW_KEY_0, ctrl, plain, Reach::always, false, "Ctrl 0", "Normal size"},
    {Command::normal_size, GLFW_KEY_KP_0, ctrl, plain, Reach::always, false, "", ""},
    {Command::show_map, by_letter, plain, plain, Reach::outside_text, false, "?", "Keys and the manual"},
    {Command::show_map, GLFW_KEY_F1, plain, plain, Reach::also_typing, false, "F1",
     "Keys and the manual, also while typing"},
};

}  // namespace

std::span<const Shortcut> shortcuts() { return table; }

void Keyboard::emit(Command c, bool down, double at_s) {
  (down ? next_.pressed : next_.released)[index(c)] = true;
  if (on_edge) on_edge(CommandEdge{c, down, at_s});
}

// Keys with Alt or Super belong to the window manager or other programs. Alt+Left means Back there and must
// not move an axis here.
const Shortcut* Keyboard::match(int key) const {
  if (modifiers_.alt || modifiers_.super) return nullptr;
  for (const Shortcut& s : table)
    if (s.key == key && s.ctrl == modifiers_.ctrl && s.shift == modifiers_.shift &&
        (s.reach != Reach::outside_text || !typing_))
      return &s;
  return nullptr;
}

bool Keyboard::stop_key(const InputEvent& event) {
  bool& taken = taken_[GLFW_KEY_ESCAPE];
  if (event.down && !taken) emit(Command::stop_all, true, event.at_s);
  if (event.down && !taken && arrived_.shift) emit(Command::stop_at_once, true, event.at_s);
  taken = event.down;
  return true;
}

bool Keyboard::key_down(const InputEvent& event) {
  bool& taken = taken_[static_cast<std::size_t>(event.code)];
  if (taken) return true;  // an auto-repeat that the window system reported as a press
  const Shortcut* s = match(event.code);
  if (!s) return false;
  taken = true;
  // The key is consumed all the same, so that Ctrl Enter does not confirm the dialog that covers the program.
  if (covered_ && s->reach != Reach::always) return true;
  if (s->held) held_[index(s->command)] = true;
  emit(s->command, true, event.at_s);
  return true;
}

bool Keyboard::key_up(const InputEvent& event) {
  bool& taken = taken_[static_cast<std::size_t>(event.code)];
  if (!taken) return false;
  taken = false;
  for (const Shortcut& s : table)
    if (s.key == event.code && s.held && held_[index(s.command)]) {
      held_[index(s.command)] = false;
      emit(s.command, false, event.at_s);
    }
  return true;
}

namespace {

bool is_key(const InputEvent& event, std::size_t known) {
  return event.kind == InputKind::key && event.code >= 0 && static_cast<std::size_t>(event.code) < known;
}

}  // namespace

bool Keyboard::on_arrival(const InputEvent& event) {
  if (event.kind == InputKind::focus_lost) {
    if (on_focus_lost) on_focus_lost(event.at_s);
    release_all(event.at_s);
    return false;
  }
  arrived_.follow(event);
  if (!is_key(event, taken_.size())) return false;
  if (event.code == GLFW_KEY_ESCAPE) return stop_key(event);
  return !event.down && key_up(event);
}

bool Keyboard::in_turn(const InputEvent& event) {
  modifiers_.follow(event);
  if (event.kind == InputKind::text) {
    if (event.code != '?' || typing_) return false;
    emit(Command::show_map, true, event.at_s);
    return true;
  }
  if (!is_key(event, taken_.size())) return false;
  return event.down ? key_down(event) : key_up(event);
}

bool Keyboard::jogging() const {
  for (auto c = index(Command::jog_left); c <= index(Command::jog_page_down); ++c)
    if (held_[c]) return true;
  return false;
}

void Keyboard::set_typing(bool typing) { typing_ = typing; }
void Keyboard::set_covered(bool covered) { covered_ = covered; }

void Keyboard::release_all(double at_s) {
  for (std::size_t i = 0; i < n; ++i)
    if (held_[i]) {
      held_[i] = false;
      emit(static_cast<Command>(i), false, at_s);
    }
  taken_.fill(false);
  arrived_ = modifiers_ = {};
}

void Keyboard::begin_frame() {
  now_ = next_;
  next_ = Edges();
}

}  // namespace hw::gui
