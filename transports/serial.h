#pragma once
// Opens a serial port, or a pseudo-terminal in its place: raw, 8N1, no flow control, exclusive.
#include <memory>
#include <string>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// Why a port could not be opened, for callers that distinguish the cases.
enum class PortRefusal { none, missing, busy, not_permitted, not_serial, other };

/// Opens the port and locks it in both ways: flock, which binds root too, and TIOCEXCL, which binds programs
/// that do not lock. The fault names the port and the program that holds it.
Result<std::unique_ptr<Stream>> open_serial(Scheduler& scheduler, const std::string& path, int baud,
                                            PortRefusal* refusal = nullptr);

}  // namespace hw
