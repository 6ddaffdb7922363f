#pragma once
// libusb on the io thread: its descriptors wait in the io loop beside all others, its callbacks come from
// there. No thread, no polling. Io thread only.
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
  /// Calls `changed` once soon, and whenever a device with these numbers is plugged in or pulled out, as long
  /// as this lives.
  Result<> watch(int vendor, int product, std::function<void()> changed);
  /// Waits (for the end of a program only) until `done` or the patience is over.
  void run_until(const std::function<bool()>& done, Millis patience);

 private:
  struct State;
  explicit UsbLoop(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

/// A sentence for an error number of libusb.
std::string usb_error(int number);

}  // namespace hw
