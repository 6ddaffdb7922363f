#pragma once
// Draws the motor power switch beside the reason that a motor has no current.
#include <cstdint>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// A bit for each axis without motor power among the axes jogged here (of many axes, the chosen one).
std::uint32_t powerless_axes(const gui::Frame& frame);
/// Why these axes cannot be moved; empty: they can.
std::string_view powerless_words(const gui::Frame& frame, std::uint32_t axes);
/// Draws a switch for each axis, `jog/X/power`, in a row at the right end of `place`. Returns the rest of
/// `place`.
gui::Rect draw_power_switches(gui::Frame& frame, const gui::Rect& place, std::uint32_t axes);

}  // namespace hw::panels
