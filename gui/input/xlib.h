#pragma once
// Functions of Xlib, which is in the process when GLFW has opened an X window; null where it has not. Its
// headers are not needed to build.
#include <dlfcn.h>

namespace hw::gui {

template <class Function>
Function from_xlib(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

/// The display of GLFW's windows; null: it is no X server.
inline void* glfw_x_display() {
  static const auto get = from_xlib<void* (*)()>("glfwGetX11Display");
  return get ? get() : nullptr;
}

}  // namespace hw::gui
