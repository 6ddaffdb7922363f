#pragma once
#include <string>

namespace hw::app {

/// The manual page handwheel(1), in the source form that man reads.
std::string manual_page();

}  // namespace hw::app
