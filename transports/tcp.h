#pragma once
#include <memory>

#include "core/base/asio.h"
#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// Connects to "HOST:PORT". Fails after `patience`. Neither name lookup nor connecting blocks the io thread.
Task<Result<std::unique_ptr<Stream>>> open_tcp(Scheduler& scheduler, std::string where,
                                               Duration patience = Millis(5000));
/// As above, but returns the connected socket, for protocols on top: non-blocking, without Nagle's delay.
Task<Result<int>> connect_tcp(Scheduler& scheduler, std::string where, Duration patience);
/// Makes a stream on a connected socket and takes ownership of it. `peer` is for messages.
std::unique_ptr<Stream> make_tcp_stream(Scheduler& scheduler, int socket, std::string peer);
/// Why a connection to `where` ended. `error`: an errno; 0: closed by the other side.
Fault tcp_ended(const std::string& where, int error);

}  // namespace hw
