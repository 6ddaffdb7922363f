#pragma once
// The true state of an emulated machine at one instant, against which tests/simulation judges the console's
// display. The console itself must not use it: a real controller does not offer it.
#include <array>
#include <cstdint>

#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw {

struct AxisTruth {
  Steps position{};     ///< the counter: the controller's answer if asked now
  bool moving = false;  ///< steps are being made, a ramp down included
  Duration ramp{};      ///< time to come to rest from the present speed
  bool operator==(const AxisTruth&) const = default;
};

struct MachineTruth {
  bool powered = true;
  bool program = false;  ///< commands of a stored program or a queue run or wait
  int axis_count = 0;
  std::array<AxisTruth, max_axes> axes{};
  [[nodiscard]] std::uint32_t moving() const {
    std::uint32_t bits = 0;
    for (int a = 0; a < axis_count; ++a)
      if (axes[static_cast<std::size_t>(a)].moving) bits |= 1u << a;
    return bits;
  }
};

}  // namespace hw
