// Esc while a program is being sent: from the key's edge, as the window's callback gives it to the keyboard,
// to the first byte of the stop at the transport. Two threads, as in the console; a wire with the byte times
// of 9,600 baud.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/device/registry.h"
#include "core/session/session.h"
#include "core/time/real_scheduler.h"
#include "transports/open.h"

namespace hw {
namespace {

using WallClock = std::chrono::steady_clock;

/// Notes when the first K or D goes out: the two letters with which a VXM is stopped; no program line has
/// them.
class Tap final : public Stream {
 public:
  Tap(std::unique_ptr<Stream> inner, std::atomic<std::int64_t>& stopped_at)
      : inner_(std::move(inner)), stopped_at_(stopped_at) {}
  void listen(Listener* listener) override { inner_->listen(listener); }
  void send(std::string_view bytes) override {
    if (stopped_at_.load() == 0 && bytes.find_first_of("KD") != bytes.npos)
      stopped_at_ = WallClock::now().time_since_epoch().count();
    inner_->send(bytes);
  }
  Result<> set_rate(int baud) override { return inner_->set_rate(baud); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Stream> inner_;
  std::atomic<std::int64_t>& stopped_at_;
};

Task<Result<Wire>> open_tapped(WireOpener opener, Scheduler& scheduler, Address address,
                               std::shared_ptr<BenchAccess> again, std::atomic<std::int64_t>& stopped_at) {
  auto wire = co_await opener(scheduler, std::move(address), std::move(again));
  if (wire) wire->stream = std::make_unique<Tap>(std::move(wire->stream), stopped_at);
  co_return std::move(wire);
}

/// A session on an io thread of its own.
struct Console {
  std::atomic<std::int64_t> stopped_at{1};
  IoContext io{1};
  RealScheduler time{io};
  asio::executor_work_guard<Executor> busy{io.get_executor()};
  std::shared_ptr<Session> session;
  std::thread thread;

  Console() {
    const WireOpener opener = [this, inner = make_wire_opener()](Scheduler& scheduler, Address address,
                                                                 std::shared_ptr<BenchAccess> again) {
      return open_tapped(inner, scheduler, std::move(address), std::move(again), stopped_at);
    };
    session = *Session::open(time, *Address::parse("vxm@emulator,wire=real"), opener, [] {});
    thread = std::thread([this] { io.run(); });
  }
  ~Console() {
    asio::co_spawn(io, session->close(), asio::detached);
    busy.reset();
    thread.join();
  }
  template <class Done>
  bool wait(Done done, double patience_s = 20) {
    const auto began = WallClock::now();
    while (!done(session->snapshot())) {
      session->traffic().drain([](TrafficEntry&) {});
      session->notices().drain([](Notice&) {});
      if (std::chrono::duration<double>(WallClock::now() - began).count() > patience_s) return false;
      std::this_thread::sleep_for(Millis(1));
    }
    return true;
  }
};

std::string long_program() {
  std::string text;
  for (int i = 0; i < 40; ++i) text += "I1M400\nP5\n";
  return text;
}

void stop_while_a_program_is_sent(benchmark::State& state) {
  Console console;
  if (!console.wait([](const Snapshot& s) { return s.link.state == LinkState::good; }))
    return state.SkipWithError("no connection");
  const std::string program = long_program();
  std::vector<double> waits;
  unsigned dice = 1;
  for (auto _ : state) {
    const auto transfers = console.session->send(intent::LoadProgram(0, program));
    dice = dice * 1'103'515'245 + 12'345;
    std::this_thread::sleep_for(std::chrono::microseconds(20'000 + dice % 60'000));
    console.stopped_at = 0;
    const auto pressed = WallClock::now();
    const auto id = console.session->send(intent::Stop());
    while (console.stopped_at == 0) std::this_thread::yield();
    const double waited = 1e-9 * static_cast<double>(console.stopped_at - pressed.time_since_epoch().count());
    waits.push_back(waited);
    state.SetIterationTime(waited);
    const bool both_over = console.wait([&](const Snapshot& s) {
      const IntentFate *stop = s.fate_of(id), *transfer = s.fate_of(transfers);
      return stop && transfer && stop->fate != Fate::pending && transfer->fate != Fate::pending;
    });
    if (!both_over) return state.SkipWithError("the stop did not end");
  }
  std::sort(waits.begin(), waits.end());
  const auto at = [&](double share) {
    return 1e6 * waits[static_cast<std::size_t>(share * static_cast<double>(waits.size() - 1))];
  };
  state.counters["p50_us"] = at(0.5);
  state.counters["p99_us"] = at(0.99);
  state.counters["worst_us"] = at(1);
}
BENCHMARK(stop_while_a_program_is_sent)->UseManualTime()->Iterations(200)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hw
