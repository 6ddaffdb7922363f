#pragma once
// Where everything is tied together: the transports behind an address, the threads, the end of it all.
#include <functional>
#include <memory>
#include <thread>

#include "core/base/asio.h"
#include "core/session/session.h"
#include "core/time/real_scheduler.h"

namespace hw::app {

/// Every transport of the house. `keeper`: of the last wills of held jogs; null: nobody.
WireOpener wire_opener(std::shared_ptr<WillKeeper> keeper = nullptr);

/// Starts the watchdog of held jogs: before any thread.
std::shared_ptr<WillKeeper> start_jog_watchdog();

/// Wall-clock time with a thread of its own, for the console.
class IoThread {
 public:
  IoThread();
  ~IoThread() { stop(); }
  /// Joins; what still waits is dropped.
  void stop();
  IoThread(const IoThread&) = delete;
  IoThread& operator=(const IoThread&) = delete;
  [[nodiscard]] Scheduler& scheduler() { return scheduler_; }

 private:
  IoContext io_{1};
  RealScheduler scheduler_{io_};
  asio::executor_work_guard<Executor> busy_{io_.get_executor()};
  std::thread thread_;
};

/// Runs a headless job in wall-clock time on this thread; its answer is the exit status.
int run_here(const std::function<Task<int>(Scheduler&)>& job);

/// Calls `act` (io thread) when somebody wants the program to end: SIGINT, SIGTERM, SIGHUP. A second signal
/// ends it the hard way.
class Interruption {
 public:
  Interruption(Scheduler& scheduler, std::function<void(int signal)> act);

 private:
  asio::basic_signal_set<Executor> signals_;
};

/// A session that is connected, or why not. Closes it again when it cannot connect.
Task<Result<std::shared_ptr<Session>>> connect(Scheduler& scheduler, Address address, WireOpener opener);

/// Once, before anything is opened: a pipe that nobody reads is an error of the write and no end of the
/// program, and no port is opened under the number of a standard stream that is closed.
void prepare_process();

}  // namespace hw::app
