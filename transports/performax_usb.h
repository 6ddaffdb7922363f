#pragma once
// The USB wire of Performax controllers, as their maker's library speaks on it: one command in one transfer
// of 64 bytes, zero-filled; one reply in another, up to its first zero. No address, no terminator.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

struct PerformaxDevice {
  std::string serial;   ///< the device's name in lower case, "4ex00": what an address gives
  std::string product;  ///< "Performax USB"
  int bus = 0, number = 0;
  bool permitted = true;  ///< this user may open it
};

/// What to do when a user may not open one.
extern const char* const udev_advice;

/// Those that are plugged in now, whether they may be opened or not. Opens none; any thread.
std::vector<PerformaxDevice> list_performax(const std::string& sys = "/sys");

/// `serial` empty: the only one. Resumes when the controller listens and what it had to say before is gone.
/// The fault is a sentence that says what to do, also where the user may not open it.
Task<Result<std::unique_ptr<Stream>>> open_performax_usb(Scheduler& scheduler, std::string serial);

/// Calls `changed` (io thread) whenever one is plugged in or pulled out, until it is destroyed (there too);
/// and once to begin with, because nothing tells of what happened before it watched.
class PerformaxWatch {
 public:
  virtual ~PerformaxWatch() = default;
  static Result<std::unique_ptr<PerformaxWatch>> start(Scheduler& scheduler, std::function<void()> changed);
};

}  // namespace hw
