#pragma once
// Ends the process when a script stays inside one call of Lua's library for too long: such a call (a pattern
// that backtracks for ever) cannot be interrupted from inside.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace hw::app {

class Watchdog {
 public:
  /// `heartbeat` must change at least once in `patience` while `at_work` is true.
  Watchdog(const std::atomic<std::uint64_t>& heartbeat, const std::atomic<bool>& at_work,
           std::chrono::seconds patience);
  ~Watchdog();

 private:
  void watch(std::chrono::seconds patience);
  const std::atomic<std::uint64_t>& heartbeat_;
  const std::atomic<bool>& at_work_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace hw::app
