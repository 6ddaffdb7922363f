#include "gui/input/keyboard_grabs.h"

#include <utility>

#include "gui/input/xlib.h"

namespace hw::gui {
namespace {

// From X.h and Xlib.h.
constexpr long focus_change_mask = 1L << 21;
constexpr int focus_in = 9, focus_out = 10, notify_grab = 1, notify_ungrab = 2;
struct FocusChange {
  int type;
  unsigned long serial;
  int send_event;
  void* display;
  unsigned long window;
  int mode, detail;
};
union Event {
  FocusChange focus;
  long room[24];
};

}  // namespace

KeyboardGrabs::~KeyboardGrabs() {
  if (display_) from_xlib<int (*)(void*)>("XCloseDisplay")(display_);
}

void KeyboardGrabs::watch(GLFWwindow* window) {
  const auto window_of = from_xlib<unsigned long (*)(GLFWwindow*)>("glfwGetX11Window");
  const auto open = from_xlib<void* (*)(const char*)>("XOpenDisplay");
  const auto name_of = from_xlib<const char* (*)(void*)>("XDisplayString");
  const auto select = from_xlib<int (*)(void*, unsigned long, long)>("XSelectInput");
  void* const shown_on = glfw_x_display();
  if (!shown_on || !window_of || !open || !name_of || !select) return;
  display_ = open(name_of(shown_on));
  if (!display_) return;
  select(display_, window_of(window), focus_change_mask);
  read();  // sends the request
}

void KeyboardGrabs::read() {
  if (!display_) return;
  static const auto pending = from_xlib<int (*)(void*)>("XPending");
  static const auto next = from_xlib<int (*)(void*, Event*)>("XNextEvent");
  while (pending(display_) > 0) {
    Event event;
    next(display_, &event);
    const FocusChange& change = event.focus;
    if (change.type == focus_out && change.mode == notify_grab) news_.push_back(true);
    if (change.type == focus_in && change.mode == notify_ungrab) news_.push_back(false);
  }
}

std::vector<bool> KeyboardGrabs::take_news() {
  read();
  return std::exchange(news_, {});
}

bool KeyboardGrabs::is_given_back() {
  read();
  return !news_.empty() && !news_.back();
}

}  // namespace hw::gui
