#pragma once
// Opens a board's 4 KiB window in the memory of this computer: through Linux' user-space VME device, whose
// window onto the short address space is set first, or through any file that can be mapped (a UIO device,
// /dev/mem, or a plain file in place of a board). There are no interrupts: the device can generate an
// interrupt on the bus (VME_IRQ_GEN), but a program cannot wait for one.
#include <cstdint>
#include <memory>
#include <string>

#include "core/link/window.h"
#include "core/time/scheduler.h"

namespace hw {

/// As ::ioctl.
using DeviceRequest = int (*)(int fd, unsigned long request, void* argument);

/// `base` is the start of the board's window in the short address space, a multiple of 0x1000. It is ignored
/// for a plain file of at most 4 KiB, which is the window itself.
Result<std::unique_ptr<Window>> open_vme_device(Scheduler& scheduler, const std::string& device,
                                                std::uint32_t base, DeviceRequest request = nullptr);

}  // namespace hw
