// Emulators against real time: a program of an hour, and a room full of controllers that a host polls.
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/device/registry.h"
#include "core/emulation/emulator.h"

namespace hw {
namespace {

// 60 x (10 moves there and back, a pause): a little over an hour of the controller's time.
constexpr const char* an_hour = "F,PM-0,S1M2000,A1M2,LM0,I1M4000,P10,I1M-4000,P10,LA600,";

void advance_event_by_event(Emulator& e, Instant until) {
  for (;;) {
    const auto next = e.next_event();
    if (!next || *next > until) break;
    e.advance_to(*next);
  }
  e.advance_to(until);
}

void program_of_an_hour(benchmark::State& state) {
  const DeviceType& type = *find_device_type("vxm");
  double simulated = 0;
  for (auto _ : state) {
    auto emulator = *type.make_emulator({});
    emulator->advance_to(Instant(std::chrono::seconds(10)));
    emulator->receive(an_hour);
    emulator->receive("R");
    std::string out;
    Instant now(std::chrono::seconds(10));
    while (out.find('^') == out.npos) {
      const auto next = emulator->next_event();
      if (!next) return state.SkipWithError("the program does not end");
      now = *next;
      emulator->advance_to(now);
      emulator->take_output(out);
    }
    simulated = seconds(now) - 10;
  }
  state.counters["simulated_s"] = simulated;
  state.counters["times_real"] =
      benchmark::Counter(simulated * state.iterations(), benchmark::Counter::kIsRate);
}
BENCHMARK(program_of_an_hour)->Unit(benchmark::kMillisecond);

// One second of 1,000 controllers, each asked X, Y and V five times. Under 1,000 ms: one core bears them all.
void second_of_a_thousand_polled(benchmark::State& state) {
  const DeviceType& type = *find_device_type("vxm");
  std::vector<std::unique_ptr<Emulator>> room;
  for (int i = 0; i < 1000; ++i) {
    room.push_back(*type.make_emulator({}));
    room.back()->advance_to(Instant(std::chrono::seconds(10)));
    room.back()->receive("F");
  }
  Instant now(std::chrono::seconds(10));
  std::string out;
  for (auto _ : state) {
    for (int poll = 0; poll < 5; ++poll) {
      now += Millis(200);
      for (auto& e : room) {
        advance_event_by_event(*e, now);
        for (const char* question : {"X", "Y", "V"}) {
          e->receive(question);
          e->take_output(out);
        }
        out.clear();
      }
    }
  }
}
BENCHMARK(second_of_a_thousand_polled)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hw
