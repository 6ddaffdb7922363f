#pragma once
#include "gui/shell/frame.h"

namespace hw::panels {

/// Draws a row for each axis, on a bus for each device, with its bench commands. Ids: `bench/jam/X`,
/// `bench/limit/X/-`, `bench/home/X`, `bench/alarm/X`, `bench/slip/X`.
void draw_bench_axes(gui::Frame& frame);

}  // namespace hw::panels
