#pragma once
// The drawing that the demonstration cuts: a plate with round corners, four holes and a star, in mm.
#include <string>

namespace hw::app {

/// A DXF file's text.
std::string demo_drawing();

}  // namespace hw::app
