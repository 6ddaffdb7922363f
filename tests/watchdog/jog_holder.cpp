// Opens ADDRESS and holds a jog of its first axis until it is killed, as the console does for a hand. Started
// by watchdog_test.cpp, which kills it. SIGUSR1: its io thread stops for two seconds, and goes on.
#include <cstdio>
#include <thread>

#include "core/session/session.h"
#include "core/time/real_scheduler.h"
#include "transports/open.h"
#include "transports/watchdog/jog_watchdog.h"

namespace {

using namespace hw;

void print_word(const char* word) {
  std::puts(word);
  std::fflush(stdout);
}

Task<> hold(Scheduler& scheduler, Address address, std::shared_ptr<WillKeeper> watchdog) {
  OpenOptions options;
  options.keeper = watchdog;
  auto opened = Session::open(scheduler, address, make_wire_opener(options), nullptr);
  if (!opened) co_return print_word(opened.error().sentence().c_str());
  const auto connected = co_await (*opened)->wait_until_connected();
  if (!connected) co_return print_word(connected.error().sentence().c_str());
  (*opened)->post(intent::JogStart(AxisId{0}, Sign::plus));
  Event never(scheduler);
  for (Instant lost_before = (*opened)->known().link.lost_at, jogged{};;) {
    co_await never.wait_until(scheduler.now() + Millis(50));
    const Snapshot& now = (*opened)->known();
    if (now.axes[0].activity == Activity::jogging && jogged == Instant{}) {
      print_word(now.link.jog_ends == JogEnds::by_watchdog ? "jogging, watched" : "jogging");
      jogged = scheduler.now();
    }
    if (now.link.lost_at != std::exchange(lost_before, now.link.lost_at)) print_word("lost");
    (*opened)->post(intent::JogKeepAlive());
  }
}

}  // namespace

int main(int, char** words) {
  auto watchdog = JogWatchdog::start({words[2]});
  if (watchdog) watchdog->report_fatal_signals();
  const auto address = Address::parse(words[1]);
  if (!address) return 1;
  IoContext io{1};
  RealScheduler scheduler(io);
  boost::asio::basic_signal_set<Executor> pause(io.get_executor(), SIGUSR1);
  pause.async_wait([](auto, int) { std::this_thread::sleep_for(std::chrono::seconds(2)); });
  boost::asio::co_spawn(io.get_executor(), hold(scheduler, *address, watchdog), boost::asio::detached);
  io.run();
}
