#pragma once
// What `handwheel demo` does where there is no display: emulated controllers at work, told line by line, and
// pictures of the console.
#include <string>
#include <string_view>

namespace hw::app {

int headless_demo(const std::string& pictures);
void print_line(std::string_view line);
std::string folder_of_program();

}  // namespace hw::app
