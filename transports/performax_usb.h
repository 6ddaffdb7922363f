#pragma once
// The USB wire of Performax controllers, in the format of the maker's library: a command is a transfer of 64
// bytes, zero-filled; a reply is another, up to its first zero. There is no address and no terminator.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

struct PerformaxDevice {
  std::string serial;   ///< the device's name in lower case, as in an address: "4ex00"
  std::string product;  ///< "Performax USB"
  int bus = 0, number = 0;
  bool permitted = true;  ///< this user may open the device
};

/// Advice for a user who may not open the device.
extern const char* const udev_advice;

/// The devices plugged in now, permitted or not. Opens no device. Any thread.
std::vector<PerformaxDevice> list_performax(const std::string& sys = "/sys");

/// Opens the device `serial`; empty: the only device. Resumes when the controller listens and its old output
/// is discarded. The fault includes the remedy, also for missing permission.
Task<Result<std::unique_ptr<Stream>>> open_performax_usb(Scheduler& scheduler, std::string serial);

/// Calls `changed` (io thread) when a device is plugged in or unplugged, and once at the start, because
/// earlier changes were not seen. Destroy it on the io thread.
class PerformaxWatch {
 public:
  virtual ~PerformaxWatch() = default;
  static Result<std::unique_ptr<PerformaxWatch>> start(Scheduler& scheduler, std::function<void()> changed);
};

}  // namespace hw
