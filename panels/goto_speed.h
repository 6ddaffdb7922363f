#pragma once
// Works out the speed of a move of Go. The user types one number for all axes, whatever their units.
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "gui/shell/frame.h"

namespace hw::panels {

struct GoSpeed {
  Pps speed;                        ///< 0: 0: the controller's own speed
  intent::AxisSpeeds own_speeds{};  ///< for axes that move one after another
};

/// `typed` counts in the unit of each axis that goes. Axes that move together have this speed along their
/// path if their unit is the same; otherwise the fastest axis has this speed in its own unit. An axis without
/// a unit is no faster, in steps, than the slowest axis with a unit. `by`: `targets` are distances.
GoSpeed speed_of_go(const gui::Frame& frame, const std::vector<AxisTarget>& targets, bool by, double typed);
/// " For several axes: along their path.": says which speed the typed speed is when axes move together.
/// Empty: they do not. `axes` has a bit for each axis that would go.
[[nodiscard]] std::string_view speed_together_is(const gui::Frame& frame, std::uint32_t axes);

}  // namespace hw::panels
