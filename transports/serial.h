#pragma once
// A serial port, or a pseudo-terminal that stands for one: raw, 8N1, no flow control, opened exclusively.
#include <memory>
#include <string>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

/// Why a port could not be opened, for those that treat the cases differently.
enum class PortRefusal { none, missing, busy, not_permitted, not_serial, other };

/// Exclusively means both ways there are: flock, which also binds root, and TIOCEXCL, which also binds
/// programs that do not lock. The fault is a sentence that names the port and who holds it.
Result<std::unique_ptr<Stream>> open_serial(Scheduler& scheduler, const std::string& path, int baud,
                                            PortRefusal* refusal = nullptr);

}  // namespace hw
