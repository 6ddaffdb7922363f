// Thirty controllers on one line at 115,200 baud, polled as often as it goes: how much of what the wire can
// carry it does carry (share_of_wire), how evenly (spread), and what a second of it costs this machine.
#include <algorithm>

#include <benchmark/benchmark.h>

#include "tests/transports/bus_stage.h"
#include "tests/transports/toy_bus.h"

namespace hw {
namespace {

constexpr int devices = 30, baud = 115200;
constexpr double bits_of_a_poll = 10 * (5 + 5);  // @01P<CR> 0400<CR>

struct Bus : test::BusStage {
  Bus() {
    type.make_driver = [](DriverContext context) -> std::unique_ptr<Driver> {
      return std::make_unique<test::BusToyDriver>(std::move(context));
    };
    std::vector<HostedDevice> toys;
    for (int i = 1; i <= devices; ++i)
      toys.push_back(HostedDevice{id_of(i), std::make_unique<test::BusToy>(id_of(i), baud)});
    serve(std::move(toys));
    for (int i = 1; i <= devices; ++i) {
      Catalog catalog;
      catalog.address = i;
      catalog.axes.push_back({"X", "motor"});
      connect(type, std::move(catalog));
    }
    run(1);
  }
  ~Bus() { close_all(); }
  int polls(int device) {
    return static_cast<const test::BusToy&>(host->bench(static_cast<std::size_t>(device))->emulator()).polls;
  }

  DeviceType type{};
};

void second_of_a_bus_of_thirty(benchmark::State& state) {
  Bus bus;
  std::vector<int> before;
  for (int i = 0; i < devices; ++i) before.push_back(bus.polls(i));
  double span = 0;
  for (auto _ : state) {
    bus.time.run_for(std::chrono::seconds(1));
    ++span;
  }
  int fewest = 1 << 30, most = 0, all = 0;
  for (int i = 0; i < devices; ++i) {
    const int n = bus.polls(i) - before[static_cast<std::size_t>(i)];
    fewest = std::min(fewest, n), most = std::max(most, n), all += n;
  }
  state.counters["share_of_wire"] = all * bits_of_a_poll / (baud * span);
  state.counters["spread"] = static_cast<double>(most - fewest) / fewest;
}
BENCHMARK(second_of_a_bus_of_thirty)->Unit(benchmark::kMillisecond)->MinTime(2);

}  // namespace
}  // namespace hw
