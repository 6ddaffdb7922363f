#pragma once
// Steps or real units, and what hangs on each axis (`dro/unit`).
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

void draw_unit_chooser(gui::Frame& frame);
/// What positions are shown in: "mm", "pulses"; of axes that differ what most of them would say.
std::string_view shown_unit(const gui::Frame& frame);
/// Logical.
float unit_chooser_width(const gui::Frame& frame);

}  // namespace hw::panels
