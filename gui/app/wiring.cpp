#include "gui/app/wiring.h"

#include <csignal>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

#include "core/base/log.h"
#include "gui/app/demo.h"
#include "transports/open.h"
#include "transports/watchdog/jog_watchdog.h"

namespace hw::app {

WireOpener wire_opener(std::shared_ptr<WillKeeper> keeper) {
  OpenOptions options;
  options.keeper = std::move(keeper);
  options.trouble = [](const Fault& fault) { log::error("link", fault.sentence()); };
  return make_wire_opener(std::move(options));
}

std::shared_ptr<WillKeeper> start_jog_watchdog() {
  const std::string here = folder_of_program();
  auto watchdog =
      JogWatchdog::start({here + "/handwheel-watchdog", here + "/../libexec/handwheel/handwheel-watchdog"});
  if (watchdog) watchdog->report_fatal_signals();
  return watchdog;
}

IoThread::IoThread() : thread_([this] { io_.run(); }) {}

void IoThread::stop() {
  if (!thread_.joinable()) return;
  busy_.reset();
  io_.stop();
  thread_.join();
}

static Task<> keep_status(const std::function<Task<int>(Scheduler&)>& job, Scheduler& scheduler,
                          std::optional<int>& status) {
  status = co_await job(scheduler);
}

int run_here(const std::function<Task<int>(Scheduler&)>& job) {
  IoContext io{1};
  RealScheduler scheduler(io);
  std::optional<int> status;
  std::exception_ptr defect;
  asio::co_spawn(io.get_executor(), keep_status(job, scheduler, status),
                 [&](std::exception_ptr error) { defect = error; });
  while (!status && !defect) io.run_one();
  io.poll();  // lets closed objects finish
  if (defect) std::rethrow_exception(defect);
  return *status;
}

Interruption::Interruption(Scheduler& scheduler, std::function<void(int signal)> act)
    : signals_(scheduler.executor(), SIGINT, SIGTERM, SIGHUP) {
  signals_.async_wait([this, act = std::move(act)](boost::system::error_code error, int signal) {
    if (error) return;
    signals_.clear();  // restores the default action of the signals
    act(signal);
  });
}

Task<Result<std::shared_ptr<Session>>> connect(Scheduler& scheduler, Address address, WireOpener opener) {
  auto opened = Session::open(scheduler, address, std::move(opener), nullptr);
  if (!opened) co_return fail(opened.error());
  std::shared_ptr<Session> session = std::move(*opened);
  const auto connected = co_await session->wait_until_connected();
  if (connected) co_return session;
  co_await session->close();
  co_return fail(connected.error());
}

void prepare_process() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // makes exceeding the file size limit a write error
  // New files get the lowest free number. /dev/null is opened for reading only, so that writing still fails.
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

}  // namespace hw::app
