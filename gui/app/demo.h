#pragma once
// Runs `handwheel demo` without a display: emulated controllers work, each step is printed, and pictures of
// the console are written.
#include <string>

namespace hw::app {

int headless_demo(const std::string& pictures);
std::string folder_of_program();

}  // namespace hw::app
