#pragma once
// The DMX-K-SA in miniature. Options of the address: id=01..99 (the device number of a fresh memory),
// quirk=reply-cr (replies end with CR instead of NUL) and quirk=motor-power (the load stands still while the
// motor is off; two are joined by +), unaddressed=yes (text without @NN is obeyed too); baud= is the line's
// and is only checked.
//
// The bench as it is built: the motor turns freely, its encoder gives 4,000 counts for 3,200 pulses and an
// index mark each turn, the first half a turn away. Limits, home and inputs are released.
#include <map>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/emulation/emulator.h"

namespace hw::dmx_k_sa {

[[nodiscard]] Result<std::unique_ptr<Emulator>> make_emulator(
    const std::map<std::string, std::string>& options);

}  // namespace hw::dmx_k_sa
