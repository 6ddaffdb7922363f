#pragma once
// Connects the parts of the program: transports, threads and shutdown.
#include <functional>
#include <memory>
#include <thread>

#include "core/base/asio.h"
#include "core/session/session.h"
#include "core/time/real_scheduler.h"

namespace hw::app {

/// Returns an opener for all transports of the program. `keeper` carries out the last wills of held jogs;
/// null: no watchdog runs.
WireOpener wire_opener(std::shared_ptr<WillKeeper> keeper = nullptr);

/// Starts the watchdog of held jogs; call before starting any thread.
std::shared_ptr<WillKeeper> start_jog_watchdog();

/// Wall-clock time on a separate thread, for the console.
class IoThread {
 public:
  IoThread();
  ~IoThread() { stop(); }
  /// Joins the thread and drops waiting work.
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

/// Calls `act` on the io thread when SIGINT, SIGTERM or SIGHUP asks the program to end. A second signal kills
/// the program.
class Interruption {
 public:
  Interruption(Scheduler& scheduler, std::function<void(int signal)> act);

 private:
  asio::basic_signal_set<Executor> signals_;
};

/// Returns a connected session. A session that cannot connect is closed, and its fault returned.
Task<Result<std::shared_ptr<Session>>> connect(Scheduler& scheduler, Address address, WireOpener opener);

/// Call once, before any file or port is opened. Writing to a pipe without a reader then fails instead of
/// ending the program, and no port gets the number of a closed standard stream.
void prepare_process();

}  // namespace hw::app
