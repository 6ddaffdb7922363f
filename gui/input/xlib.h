#pragma once
// Xlib functions, present in the process once GLFW has opened an X window; else null. Xlib's headers are not
// needed to build.
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
