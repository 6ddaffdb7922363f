#pragma once
// Runs libusb in the io loop, which waits for its descriptors and makes its callbacks. No thread, no polling.
// Io thread only.
#include <functional>
#include <memory>

#include "core/base/result.h"
#include "core/time/scheduler.h"

struct libusb_context;
struct libusb_device_handle;

namespace hw {

class UsbLoop {
 public:
  static Result<std::unique_ptr<UsbLoop>> make(Scheduler& scheduler);
  ~UsbLoop();  ///< all handles must be closed
  UsbLoop(const UsbLoop&) = delete;
  UsbLoop& operator=(const UsbLoop&) = delete;

  [[nodiscard]] libusb_context* context() const;
  /// Calls `changed` once soon, and then when a device with these ids is plugged in or unplugged, for the
  /// lifetime of this object.
  Result<> watch(int vendor, int product, std::function<void()> changed);
  /// Blocks until `done` or until `patience` is over. Only at program end.
  void run_until(const std::function<bool()>& done, Millis patience);

 private:
  struct State;
  explicit UsbLoop(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

/// The message for a libusb error number.
std::string usb_error(int number);

}  // namespace hw
