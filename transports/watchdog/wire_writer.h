#pragma once
// Puts bytes on a wire that another program has opened, in whichever way that goes. In the watchdog only.
#include <string_view>

#include "transports/watchdog/will_message.h"

namespace hw::watchdog {

/// `fd`: that of the will, or -1. Gives up after a moment: there is nobody to tell.
void write_to_wire(const Message& will, int fd, std::string_view bytes);

}  // namespace hw::watchdog
