#pragma once
// Writes bytes to a wire that another program has opened. Only in the watchdog.
#include <string_view>

#include "transports/watchdog/will_message.h"

namespace hw::watchdog {

/// Writes to the will's descriptor `fd`; -1: it has none. Gives up after a moment without a report.
void write_to_wire(const Message& will, int fd, std::string_view bytes);

}  // namespace hw::watchdog
