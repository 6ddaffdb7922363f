#pragma once
// The motor power switch beside the reason, shown when that says that a motor has no current.
#include <cstdint>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// Bit per axis without motor power among those jogged here (of many axes, the chosen one).
std::uint32_t powerless_axes(const gui::Frame& frame);
/// Why these axes cannot be moved. Empty: they can.
std::string_view powerless_words(const gui::Frame& frame, std::uint32_t axes);
/// Draws a switch for each, `jog/X/power`, in one row at the right end of `place`. Returns the rest of
/// `place` at their left.
gui::Rect draw_power_switches(gui::Frame& frame, const gui::Rect& place, std::uint32_t axes);

}  // namespace hw::panels
