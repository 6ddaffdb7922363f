#pragma once
#include "gui/shell/frame.h"

namespace hw::panels {

/// Draws the repeatability of the switches, common to all axes of a controller or a bus. Id: `bench/scatter`.
void draw_switch_scatter(gui::Frame& frame);

}  // namespace hw::panels
