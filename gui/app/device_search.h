#pragma once
// Searches ports, rates and ids for the connection page (transports/scan), on the io thread.
#include <atomic>
#include <functional>
#include <memory>

#include "core/base/ring.h"
#include "core/time/scheduler.h"
#include "gui/shell/device_finder.h"
#include "transports/scan.h"

namespace hw::app {

class DeviceSearcher final : public gui::DeviceFinder {
 public:
  DeviceSearcher(Scheduler& scheduler, std::function<void()> wake)
      : scheduler_(scheduler), wake_(std::move(wake)) {}
  ~DeviceSearcher() override { cancel(); }

  void start(const std::string& path, int baud, int first_id, int last_id) override;
  void cancel() override;
  const gui::DeviceSearchState& state() override;

  /// Passes progress from the io thread to the GUI thread.
  struct Wire {
    std::atomic<bool> go_on{true};
    std::atomic<bool> over{false};
    Ring<SearchProgress> progress{256};
    Ring<PortReport> found{256};
  };

 private:
  Scheduler& scheduler_;
  std::function<void()> wake_;
  std::shared_ptr<Wire> wire_;  ///< of the newest search
  gui::DeviceSearchState state_;
};

}  // namespace hw::app
