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
#include "transports/byte_line.h"
#include "transports/open.h"

namespace hw {
namespace {

using WallClock = std::chrono::steady_clock;

std::int64_t now_ns() { return WallClock::now().time_since_epoch().count(); }

/// When the first byte of a stop went out, and when the wire was done with what had been on it before.
struct Moments {
  std::atomic<std::int64_t> stopped_at{1};  ///< 0: not yet
  std::atomic<std::int64_t> wire_free_at{0};
};

/// Watches for K or D, the letters with which a VXM is stopped; no line of the program has them. A
/// transaction ends with the last byte of its reply, or with its own where there is none.
class Tap final : public Stream, private Stream::Listener {
 public:
  Tap(std::unique_ptr<Stream> inner, Moments& moments) : inner_(std::move(inner)), moments_(moments) {
    inner_->listen(this);
  }
  void listen(Stream::Listener* listener) override { listener_ = listener; }
  void discard_unsent() override { inner_->discard_unsent(); }
  void send(std::string_view bytes) override {
    if (moments_.stopped_at == 0) {
      if (bytes.find_first_of("KD") != bytes.npos)
        moments_.stopped_at = now_ns();
      else
        moments_.wire_free_at = now_ns() + (byte_time(rate()) * bytes.size()).count();
    }
    inner_->send(bytes);
  }
  Result<> set_rate(int baud) override { return inner_->set_rate(baud); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  void bytes_arrived(std::string_view bytes) override {
    if (moments_.stopped_at == 0) moments_.wire_free_at = now_ns();
    if (listener_) listener_->bytes_arrived(bytes);
  }
  void stream_closed(const Fault& why) override {
    if (listener_) listener_->stream_closed(why);
  }

  std::unique_ptr<Stream> inner_;
  Moments& moments_;
  Stream::Listener* listener_ = nullptr;
};

Task<Result<Wire>> open_tapped(WireOpener opener, Scheduler& scheduler, Address address,
                               std::shared_ptr<BenchAccess> again, Moments& moments) {
  auto wire = co_await opener(scheduler, std::move(address), std::move(again));
  if (wire) wire->stream = std::make_unique<Tap>(std::move(wire->stream), moments);
  co_return std::move(wire);
}

/// A session on an io thread of its own.
struct Console {
  Moments moments;
  IoContext io{1};
  RealScheduler time{io};
  asio::executor_work_guard<Executor> busy{io.get_executor()};
  std::shared_ptr<Session> session;
  std::thread thread;

  Console() {
    const WireOpener opener = [this, inner = make_wire_opener()](Scheduler& scheduler, Address address,
                                                                 std::shared_ptr<BenchAccess> again) {
      return open_tapped(inner, scheduler, std::move(address), std::move(again), moments);
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
  std::vector<double> waits, total;
  unsigned dice = 1;
  for (auto _ : state) {
    const auto transfers = console.session->send(intent::LoadProgram(0, program));
    dice = dice * 1'103'515'245 + 12'345;
    std::this_thread::sleep_for(std::chrono::microseconds(20'000 + dice % 60'000));
    console.moments.stopped_at = 0;
    const std::int64_t pressed = now_ns();
    const auto id = console.session->send(intent::Stop());
    while (console.moments.stopped_at == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    const std::int64_t could = std::max<std::int64_t>(pressed, console.moments.wire_free_at);
    const double waited =
        1e-9 * static_cast<double>(std::max<std::int64_t>(console.moments.stopped_at - could, 0));
    total.push_back(1e-9 * static_cast<double>(console.moments.stopped_at - pressed));
    waits.push_back(waited);
    state.SetIterationTime(waited);
    const bool both_over = console.wait([&](const Snapshot& s) {
      const IntentOutcome *stop = s.outcome_of(id), *transfer = s.outcome_of(transfers);
      return stop && transfer && stop->state != IntentState::pending &&
             transfer->state != IntentState::pending;
    });
    if (!both_over) return state.SkipWithError("the stop did not end");
  }
  std::sort(waits.begin(), waits.end());
  std::sort(total.begin(), total.end());
  const auto part = [](const std::vector<double>& sorted, double share) {
    return 1e6 * sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  const auto at = [&](double share) { return part(waits, share); };
  state.counters["p99_us_with_the_transaction"] = part(total, 0.99);
  state.counters["p50_us"] = at(0.5);
  state.counters["p99_us"] = at(0.99);
  state.counters["worst_us"] = at(1);
}
BENCHMARK(stop_while_a_program_is_sent)->UseManualTime()->Iterations(200)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hw
