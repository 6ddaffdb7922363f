#pragma once
// Connects the parts of the program: the transports behind an address, the threads, the shutdown.
#include <functional>
#include <memory>
#include <thread>

#include "core/base/asio.h"
#include "core/session/session.h"
#include "core/time/real_scheduler.h"

namespace hw::app {

/// Opens every transport of the program. `keeper`: carries out last wills of held jogs; null: no watchdog
/// runs.
WireOpener wire_opener(std::shared_ptr<WillKeeper> keeper = nullptr);

/// Starts the watchdog of held jogs; call before starting any thread.
std::shared_ptr<WillKeeper> start_jog_watchdog();

/// Wall-clock time on a separate thread, for the console.
class IoThread {
 public:
  IoThread();
  ~IoThread() { stop(); }
  /// Joins the thread; waiting work is dropped.
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

/// Runs a headless job in wall-clock time on this thread and returns its exit status.
int run_here(const std::function<Task<int>(Scheduler&)>& job);

/// Calls `act` (io thread) when the program is asked to end: SIGINT, SIGTERM, SIGHUP. A second signal kills
/// it.
class Interruption {
 public:
  Interruption(Scheduler& scheduler, std::function<void(int signal)> act);

 private:
  asio::basic_signal_set<Executor> signals_;
};

/// Returns a connected session, or the fault; a session that cannot connect is closed.
Task<Result<std::shared_ptr<Session>>> connect(Scheduler& scheduler, Address address, WireOpener opener);

/// Call once, before anything is opened: makes a pipe without a reader a write error instead of the program's
/// end, and keeps ports from getting the number of a closed standard stream.
void prepare_process();

}  // namespace hw::app
