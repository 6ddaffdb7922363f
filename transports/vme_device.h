#pragma once
// A board's 4 KiB window in the memory of this computer: through Linux' user-space VME device, whose window
// onto the short address space is set first, or through any file that can be mapped (a UIO device, /dev/mem,
// or a plain file that stands in for a board). Interrupts do not come this way: the device can make one on
// the bus for others (VME_IRQ_GEN), but has nothing with which a program could wait for one.
#include <cstdint>
#include <memory>
#include <string>

#include "core/link/window.h"
#include "core/time/scheduler.h"

namespace hw {

/// As ::ioctl.
using DeviceRequest = int (*)(int fd, unsigned long request, void* argument);

/// `base`: where the board's window begins in the short address space, a multiple of 0x1000. A plain file
/// that holds no more than the 4 KiB of a window is that window, whatever the base.
Result<std::unique_ptr<Window>> open_vme_device(Scheduler& scheduler, const std::string& device,
                                                std::uint32_t base, DeviceRequest request = nullptr);

}  // namespace hw
