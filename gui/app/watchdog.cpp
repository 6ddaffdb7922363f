#include "gui/app/watchdog.h"

#include <cstdlib>

#include "gui/app/cli.h"

namespace hw::app {

Watchdog::Watchdog(const std::atomic<std::uint64_t>& heartbeat, const std::atomic<bool>& at_work,
                   std::chrono::seconds patience)
    : heartbeat_(heartbeat), at_work_(at_work), thread_([this, patience] { watch(patience); }) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void Watchdog::watch(std::chrono::seconds patience) {
  std::unique_lock lock(mutex_);
  for (std::uint64_t seen = heartbeat_; !ended_.wait_for(lock, patience, [this] { return end_; });
       seen = heartbeat_)
    if (at_work_ && heartbeat_ == seen) {
      complain("The script stayed in one call of Lua's library for too long, so the run was ended.");
      std::_Exit(failed);
    }
}

}  // namespace hw::app
