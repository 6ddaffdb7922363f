#pragma once
// Finds Xlib functions in the process, where they are once GLFW has opened an X window; otherwise null. So
// building does not need Xlib's headers.
#include <dlfcn.h>

namespace hw::gui {

template <class Function>
Function from_xlib(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

/// The display of GLFW's windows; null: no X server.
inline void* glfw_x_display() {
  static const auto get = from_xlib<void* (*)()>("glfwGetX11Display");
  return get ? get() : nullptr;
}

}  // namespace hw::gui
