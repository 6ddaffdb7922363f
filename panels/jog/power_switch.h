#pragma once
// The switch beside the reason: what gives a motor its current, where it is said that it has none.
#include <cstdint>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

/// Bit per axis that is jogged here (of many, the chosen one) and has no motor power.
std::uint32_t powerless_axes(const gui::Frame& frame);
/// Why these cannot be moved. Empty: they can.
std::string_view powerless_words(const gui::Frame& frame, std::uint32_t axes);
/// A switch for each, `jog/X/power`, in one row at the right end of `place`. What it leaves of it at their
/// left.
gui::Rect draw_power_switches(gui::Frame& frame, const gui::Rect& place, std::uint32_t axes);

}  // namespace hw::panels
