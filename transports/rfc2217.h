#pragma once
// A serial port behind a terminal server, whose rate and line settings are set through the network (RFC
// 2217).
#include <memory>
#include <string>

#include "core/base/asio.h"
#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// Resumes when the server has confirmed `baud` and 8N1. Ignores modem lines.
Task<Result<std::unique_ptr<Stream>>> open_rfc2217(Scheduler& scheduler, std::string where, int baud,
                                                   Duration patience = Millis(5000));

}  // namespace hw
