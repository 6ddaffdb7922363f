#pragma once
// A pseudo-terminal that this program serves; other programs open it like a serial port.
#include <memory>
#include <string>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// Returns the master's side as a stream. `link` is a symlink to the terminal, created here and removed with
/// the stream. A stale link is replaced; any other file is a fault. The terminal is raw from the start, at
/// `baud` (0: the system's rate). Clients may connect and disconnect; bytes sent without a client are lost.
/// rate() is the rate set by the client.
Result<std::unique_ptr<Stream>> open_pty_endpoint(Scheduler& scheduler, const std::string& link, int baud);

}  // namespace hw
