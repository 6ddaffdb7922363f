#pragma once
#include <string>

namespace hw::app {

/// handwheel(1), as man reads it.
std::string manual_page();

}  // namespace hw::app
