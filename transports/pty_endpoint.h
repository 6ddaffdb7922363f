#pragma once
// A pseudo-terminal on which other programs find something of ours, as they would find a serial port.
#include <memory>
#include <string>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// The master's side as a stream. `link`: a symlink to the terminal, made here, removed with the stream; a
/// stale one is replaced, any other file is refused. Raw from the start, at `baud` (0: the system's rate).
/// Clients come and go; while none is there, what is sent is lost. rate() is the one that the client has set.
Result<std::unique_ptr<Stream>> open_pty_endpoint(Scheduler& scheduler, const std::string& link, int baud);

}  // namespace hw
