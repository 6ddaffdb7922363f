#pragma once
// A pseudo-terminal that this program serves; other programs open it like a serial port.
#include <memory>
#include <string>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// The master's side as a stream. `link`: a symlink to the terminal, created here and removed with the
/// stream; a stale link is replaced, any other file refused. Raw from the start, at `baud` (0: the system's
/// rate). Clients come and go; bytes sent without a client are lost. rate() is the rate set by the client.
Result<std::unique_ptr<Stream>> open_pty_endpoint(Scheduler& scheduler, const std::string& link, int baud);

}  // namespace hw
