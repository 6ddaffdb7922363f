#include "gui/app/watchdog.h"

#include <csignal>
#include <cstdlib>

#include "gui/app/cli.h"

namespace hw::app {
namespace {

constexpr std::chrono::seconds every(1);
constexpr std::chrono::seconds after_a_signal(1);
constexpr std::chrono::seconds to_get_it_out(5);

}  // namespace

Watchdog::Watchdog(script::Runner& runner) : runner_(runner) {
  look_later();
  thread_ = std::thread([this] { io_.run(); });
}

Watchdog::~Watchdog() {
  io_.stop();
  thread_.join();
}

void Watchdog::take_signals() {
  signals_.emplace(io_.get_executor(), SIGINT, SIGTERM, SIGHUP);
  signals_->async_wait([this](boost::system::error_code error, int) {
    if (error) return;
    signals_->clear();  // restores the default action of the signals
    interrupted_ = true;
    runner_.interrupt();
  });
}

void Watchdog::look_later() {
  timer_.expires_after(every);
  timer_.async_wait([this](boost::system::error_code error) {
    if (error) return;
    look();
    look_later();
  });
}

void Watchdog::look() {
  const std::uint64_t beat = runner_.heartbeat();
  stands_still_ = runner_.at_work() && beat == seen_ ? stands_still_ + every : std::chrono::seconds(0);
  seen_ = beat;
  const Duration patience = interrupted_ ? Duration(after_a_signal) : runner_.patience();
  if (stands_still_ < patience) return;
  if (stands_still_ < patience + to_get_it_out) return runner_.break_out(beat);
  complain(
      "Use the power switches of the controllers: the script hung in a call that cannot be interrupted, so "
      "the run was ended without a stop, and axes may still move.");
  std::_Exit(failed);
}

}  // namespace hw::app
