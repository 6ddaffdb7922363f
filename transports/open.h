#pragma once
// Opens the wire of an address: the table of transports. Keys of transports are baud (serial, rfc2217,
// emulator), and for the in-process emulator wire=real|off, speed=X, state=FILE, bench=FILE. All other keys
// belong to the device type.
#include <memory>

#include "core/device/registry.h"
#include "core/session/wire.h"
#include "transports/serve.h"

namespace hw {

struct OpenOptions {
  /// Receives failures other than those of the wire (a state file that cannot be written).
  Trouble trouble;
  /// Ends a held jog when this program dies; null: no watchdog runs.
  std::shared_ptr<WillKeeper> keeper;
};

WireOpener make_wire_opener(OpenOptions options = {});

/// Makes emulated controllers, ready to be served or plugged in: one for each of `ids`, all on the same wire.
/// Empty `ids`: one with its usual id. `keys` are those of the emulator transport and of the device type, as
/// in an address.
Result<std::shared_ptr<EmulatorHost>> make_emulator_host(Scheduler& scheduler, const DeviceType& type,
                                                         DeviceOptions keys,
                                                         const std::vector<std::string>& ids,
                                                         const OpenOptions& options);

}  // namespace hw
