#pragma once
// What an emulated machine really does at one instant, for whoever judges what is shown of it
// (tests/simulation). Nothing of the console may look here: a real controller has no such window.
#include <array>
#include <cstdint>

#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw {

struct AxisTruth {
  Steps position{};     ///< in its counter: what the controller would tell if it were asked now
  bool moving = false;  ///< makes steps by a motion of its own, a ramp down included
  Duration ramp{};      ///< that coming to rest takes from the present speed, by the axis' set-up
  bool operator==(const AxisTruth&) const = default;
};

struct MachineTruth {
  bool powered = true;
  bool program = false;  ///< commands of a stored program or of a queue are at work or wait
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
