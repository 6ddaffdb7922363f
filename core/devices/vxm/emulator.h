#pragma once
// The VXM in miniature. Options of the address: motors=1..4 (3 and 4: a Master with its Slave linked),
// quirk=overrun, quirk=e-bar, quirk=mode-while-running, quirk=old-firmware (several joined by +); baud= is
// the line's and is only checked.
//
// The bench at the start: on each motor a slide with a normally closed switch 100,000 steps to either side of
// the load, no play, and a motor small enough to turn with motor type 0 (App. M). Inputs 1-4, Run, Stop and
// the jog buttons are let go; the analog input stands in the middle (512). The Slave's inputs and outputs are
// numbers 5-8, its analog input is 2.
#include <map>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/emulation/emulator.h"

namespace hw::vxm {

inline constexpr std::int64_t default_travel = 100'000;

[[nodiscard]] Result<std::unique_ptr<Emulator>> make_emulator(
    const std::map<std::string, std::string>& options);

}  // namespace hw::vxm
