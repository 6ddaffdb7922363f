#pragma once
// The speed of a move of Go, typed as one number, whatever the units of the axes that go.
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "gui/shell/frame.h"

namespace hw::panels {

struct GoSpeed {
  Pps speed;                        ///< 0: as the controller is set up
  intent::AxisSpeeds own_speeds{};  ///< where the axes move one after another
};

/// `typed`, in the unit of each axis that goes. Axes that move together go at that speed along their path if
/// they have one unit; else the fastest of them does in its own unit. An axis without a unit beside others
/// that have one is no faster, in steps, than the slowest of those. `by`: `targets` are distances.
GoSpeed speed_of_go(const gui::Frame& frame, const std::vector<AxisTarget>& targets, bool by, double typed);
/// " For several axes: along their path.": what moves at the typed speed when axes move together. Empty: they
/// do not. `axes`: those that would go, a bit for each.
[[nodiscard]] std::string_view speed_together_is(const gui::Frame& frame, std::uint32_t axes);

}  // namespace hw::panels
