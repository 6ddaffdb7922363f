#pragma once
// Steps or real units, and what hangs on each axis (`dro/unit`).
#include "gui/frame.h"

namespace hw::panels {

void draw_unit_chooser(gui::Frame& frame);
/// Logical.
float unit_chooser_width(const gui::Frame& frame);

}  // namespace hw::panels
