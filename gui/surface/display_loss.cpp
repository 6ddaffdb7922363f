#include "gui/surface/display_loss.h"

#include <cstdlib>
#include <utility>

#include <dlfcn.h>

namespace hw::gui {
namespace {

std::function<void()> when_lost, when_failed;

int on_lost(void*) {
  if (const auto act = std::exchange(when_lost, nullptr)) act();
  std::_Exit(1);  // X would call exit(), which destroys objects that running threads still use
}

int on_failed(void*, void*) {
  if (when_failed) when_failed();
  return 0;
}

/// Finds Xlib functions in the process, where they are once GLFW has opened an X window. So building does not
/// need Xlib's headers.
template <class Handler>
void set_handler(const char* setter, Handler handler) {
  using Setter = Handler (*)(Handler);
  if (const auto set = reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, setter))) set(handler);
}

}  // namespace

DisplayGuard::DisplayGuard(std::function<void()> lost, std::function<void()> failed) {
  when_lost = std::move(lost);
  when_failed = std::move(failed);
  set_handler("XSetIOErrorHandler", &on_lost);
  set_handler("XSetErrorHandler", &on_failed);
}

// The handlers stay: without them X would terminate the program while the window is being closed.
DisplayGuard::~DisplayGuard() {
  when_lost = nullptr;
  when_failed = nullptr;
}

}  // namespace hw::gui
