#pragma once
// Writes bytes to a wire that another program has opened. In the watchdog only.
#include <string_view>

#include "transports/watchdog/will_message.h"

namespace hw::watchdog {

/// `fd`: the will's descriptor, or -1. Gives up after a moment, without a report.
void write_to_wire(const Message& will, int fd, std::string_view bytes);

}  // namespace hw::watchdog
