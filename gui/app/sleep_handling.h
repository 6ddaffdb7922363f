#pragma once
// Makes the console react when the computer goes to sleep: see sleep_watch.h. GUI thread.
#include <atomic>
#include <functional>

#include "gui/shell/console.h"
#include "transports/sleep_watch.h"

namespace hw::app {

class SleepHandling {
 public:
  /// `wake`: requests a frame; any thread.
  SleepHandling(Scheduler& scheduler, std::function<void()> wake);
  /// Call once in a frame.
  void follow(gui::Console& console);

 private:
  std::atomic<bool> wants_to_sleep_{false}, has_woken_{false};
  bool makes_ready_ = false, keeps_awake_ = false;
  SleepWatch watch_;
};

}  // namespace hw::app
