#pragma once
// The PMX-4EX-SA in miniature. Options of the address: id=00..99 (the device number of a fresh memory),
// unaddressed=yes (text without @NN is obeyed too: a TCP or USB line of its own), framing=usb (each receive()
// is one transfer, each reply 64 bytes), quirk=motor-power (a load stands still while its motor is off);
// baud= is the line's and is only checked.
//
// The bench as it is built: four axes without travel limits and without home zones, no play, encoders with
// one count per pulse, an index mark every 4,000 pulses, the first 2,000 away. Inputs and alarms are
// released, analog inputs stand at 2,500 mV.
#include <map>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/emulation/emulator.h"

namespace hw::pmx_4ex_sa {

[[nodiscard]] Result<std::unique_ptr<Emulator>> make_emulator(
    const std::map<std::string, std::string>& options);

}  // namespace hw::pmx_4ex_sa
