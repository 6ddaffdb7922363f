#pragma once
#include "gui/shell/frame.h"

namespace hw::panels {

/// A row for each axis, on a bus for each device, with all bench commands for it. `bench/jam/X`,
/// `bench/limit/X/-`, `bench/home/X`, `bench/alarm/X`, `bench/slip/X`.
void draw_bench_axes(gui::Frame& frame);

}  // namespace hw::panels
