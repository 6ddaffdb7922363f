#pragma once
// The search for devices that can share a line, when port, rate or id are not known, as the connection page
// sees it: each id at each rate of each port is asked, which takes a while and can be ended. Who asks stands
// behind this interface.
#include <string>
#include <vector>

namespace hw::gui {

struct FoundDevice {
  std::string title;    ///< the catalog's name for it
  std::string address;  ///< what opens it; empty: a port that could not be asked
  std::string sentence;
};

struct DeviceSearchState {
  bool running = false, cancelled = false;
  int asked = 0, of = 0;  ///< questions; of = 0: not begun yet
  std::string now;        ///< "/dev/ttyUSB0 at 9600 baud, id 07"
  std::vector<FoundDevice> found;
};

class DeviceFinder {
 public:
  virtual ~DeviceFinder() = default;
  /// `path`: one port; empty: all. `baud` 0: all rates. GUI thread.
  virtual void start(const std::string& path, int baud, int first_id, int last_id) = 0;
  virtual void cancel() = 0;
  /// As it is now; changes are announced by the console's wake().
  virtual const DeviceSearchState& state() = 0;
};

/// Finds nothing.
class NoDevices final : public DeviceFinder {
 public:
  void start(const std::string&, int, int, int) override {}
  void cancel() override {}
  const DeviceSearchState& state() override { return none_; }

 private:
  DeviceSearchState none_;
};

}  // namespace hw::gui
