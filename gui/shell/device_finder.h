#pragma once
// The connection page searches through this interface for devices on a shared line whose port, rate or id is
// not known. The search asks each id at each rate of each port; it is slow and can be cancelled.
#include <string>
#include <vector>

namespace hw::gui {

struct FoundDevice {
  std::string title;    ///< name from the catalog
  std::string address;  ///< address to open; empty: the port could not be asked
  std::string sentence;
};

struct DeviceSearchState {
  bool running = false, cancelled = false;
  int asked = 0, of = 0;  ///< questions; of = 0: not started yet
  std::string now;        ///< "/dev/ttyUSB0 at 9600 baud, id 07"
  std::vector<FoundDevice> found;
};

class DeviceFinder {
 public:
  virtual ~DeviceFinder() = default;
  /// Starts a search. An empty `path` means all ports, `baud` 0 all rates. GUI thread.
  virtual void start(const std::string& path, int baud, int first_id, int last_id) = 0;
  virtual void cancel() = 0;
  /// The present state; the console's wake() announces changes.
  virtual const DeviceSearchState& state() = 0;
};

/// A finder without ports.
class NoDevices final : public DeviceFinder {
 public:
  void start(const std::string&, int, int, int) override {}
  void cancel() override {}
  const DeviceSearchState& state() override { return none_; }

 private:
  DeviceSearchState none_;
};

}  // namespace hw::gui
