#pragma once
#include "gui/shell/frame.h"

namespace hw::panels {

/// Repeatability of the switches, for all axes of a controller or a bus: `bench/scatter`.
void draw_switch_scatter(gui::Frame& frame);

}  // namespace hw::panels
