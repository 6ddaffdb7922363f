#pragma once
// Runs beside a script on a thread of its own. Handles the signals that end the script, whatever the script
// does, and interrupts a Lua library call that does not return (a pattern that backtracks for ever).
#include <optional>
#include <thread>

#include "core/base/asio.h"
#include "core/script/runner.h"

namespace hw::app {

class Watchdog {
 public:
  /// `runner` must outlive this object.
  explicit Watchdog(script::Runner& runner);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  /// Makes SIGINT, SIGTERM and SIGHUP interrupt the script. A second signal kills the program.
  void take_signals();

 private:
  void look_later();
  void look();

  script::Runner& runner_;
  IoContext io_{1};
  asio::basic_waitable_timer<std::chrono::steady_clock, asio::wait_traits<std::chrono::steady_clock>,
                             Executor>
      timer_{io_.get_executor()};
  std::optional<asio::basic_signal_set<Executor>> signals_;
  std::uint64_t seen_ = 0;
  std::chrono::seconds stands_still_{};
  bool interrupted_ = false;
  std::thread thread_;
};

}  // namespace hw::app
