// Thirty controllers on one line at 115,200 baud, polled as often as it goes: how much of what the wire can
// carry it does carry (share_of_wire), how evenly (spread), and what a second of it costs this machine.
#include <algorithm>

#include <benchmark/benchmark.h>

#include "core/device/pump.h"
#include "core/session/shared_wire.h"
#include "core/time/virtual_scheduler.h"
#include "tests/transports/toy_bus.h"
#include "transports/serve.h"

namespace hw {
namespace {

constexpr int devices = 30, baud = 115200;
constexpr double bits_of_a_poll = 10 * (5 + 5);  // @01P<CR> 0400<CR>

struct Member {
  Catalog catalog;
  std::unique_ptr<Pump> pump;
};

struct Bus {
  Bus() {
    type.make_driver = [](DriverContext context) -> std::unique_ptr<Driver> {
      return std::make_unique<test::BusToyDriver>(std::move(context));
    };
    std::vector<HostedDevice> toys;
    for (int i = 0; i < devices; ++i) {
      members.emplace_back();
      members.back().catalog.address = i + 1;
      members.back().catalog.axes.push_back({"X", "motor"});
      toys.push_back(HostedDevice{members.back().catalog.id(),
                                  std::make_unique<test::BusToy>(members.back().catalog.id(), baud)});
    }
    HostOptions options;
    options.byte_times = true;
    host = *EmulatorHost::make(time, std::move(toys), options);
    wire = std::make_shared<SharedWire>(
        time, Address(), [this](Scheduler&, Address, std::shared_ptr<BenchAccess>) { return open(); });
    for (Member& member : members) {
      Pump::Ways ways;
      ways.open_wire = [this] { return wire->link(); };
      ways.publish = [](const Snapshot&) {};
      ways.notify = [](Notice) {};
      member.pump = std::make_unique<Pump>(time, type, member.catalog, std::move(ways));
      member.pump->start();
    }
    time.run_for(std::chrono::seconds(1));
  }
  ~Bus() {
    for (Member& member : members) asio::co_spawn(io, member.pump->shut_down(), asio::detached);
    time.run_for(std::chrono::seconds(1));
  }
  Task<Result<Wire>> open() {
    Wire opened;
    opened.stream = std::move(*host->plug_in());
    co_return opened;
  }
  int polls(int device) {
    return static_cast<const test::BusToy&>(host->bench(static_cast<std::size_t>(device))->emulator()).polls;
  }

  IoContext io{1};
  VirtualScheduler time{io};
  DeviceType type{};
  std::vector<Member> members;
  std::shared_ptr<EmulatorHost> host;
  std::shared_ptr<SharedWire> wire;
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
