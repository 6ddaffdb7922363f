#pragma once
#include <memory>

#include "core/base/asio.h"
#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// Connects to "HOST:PORT". The name is looked up and the connection made while the io thread goes on.
Task<Result<std::unique_ptr<Stream>>> open_tcp(Scheduler& scheduler, std::string where,
                                               Duration patience = Millis(5000));
/// The same as a bare connected socket, for protocols on top; non-blocking, without Nagle's delay.
Task<Result<int>> connect_tcp(Scheduler& scheduler, std::string where, Duration patience);
/// A connection that is already made; takes the socket over. `peer`: for sentences.
std::unique_ptr<Stream> make_tcp_stream(Scheduler& scheduler, int socket, std::string peer);
/// Why a connection to `where` ended, as a sentence. `error`: an errno; 0: closed by the other side.
Fault tcp_ended(const std::string& where, int error);

}  // namespace hw
