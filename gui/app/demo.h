#pragma once
// `handwheel demo` without a display: emulated controllers at work, reported line by line, and pictures of
// the console.
#include <string>

namespace hw::app {

int headless_demo(const std::string& pictures);
std::string folder_of_program();

}  // namespace hw::app
