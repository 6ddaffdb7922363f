#pragma once
// What the pump does for each round of status, without its pauses: driver, link, decode, publish.
#include <memory>
#include <string>

#include "core/device/driver.h"
#include "core/device/registry.h"
#include "core/session/session.h"
#include "core/time/real_scheduler.h"
#include "transports/open.h"

namespace hw {

struct Stack {
  /// Returns when the controller at `address` has answered.
  Stack(IoContext& io_context, const std::string& address) : io(io_context), time(io_context) {
    asio::co_spawn(io, live(address), asio::detached);
    while (!connected && !ended) io.run_one();
  }
  ~Stack() {
    over = true;
    while (!ended) io.run_one();
  }
  Task<> live(std::string text) {
    const auto address = Address::parse(text);
    const DeviceType& type = *find_device_type(address->model);
    catalog = *type.make_catalog({});
    snapshot.axis_count = static_cast<int>(catalog.axes.size());
    auto opener = make_wire_opener();
    auto wire = co_await opener(time, *address, nullptr);
    if (wire) {
      auto link = std::make_shared<Link>(time, std::move(wire->stream));
      station = std::make_unique<Station>(std::move(link), &traffic);
      driver = type.make_driver(DriverContext{time, catalog, snapshot, texts, [](Notice) {}, [] {}});
      driver->attach(*station);
      auto ready = co_await driver->connect();
      traffic.drain([](TrafficEntry&) {});  // what connecting took is not counted
      connected = ready.has_value();
      while (!over && ready) {
        ready = co_await driver->poll(Round::usual);
        latest.publish(snapshot);
        traffic.drain([this](TrafficEntry& entry) { wire_bytes += entry.bytes.size(); });
      }
      if (!ready) trouble = ready.error().sentence();
    } else {
      trouble = wire.error().sentence();
    }
    ended = true;
  }

  IoContext& io;
  RealScheduler time;
  Catalog catalog;
  Snapshot snapshot;
  ScriptTexts texts;
  Latest<Snapshot> latest;
  TrafficRing traffic{1 << 12};
  std::uint64_t wire_bytes = 0;  ///< both ways
  std::unique_ptr<Station> station;
  std::unique_ptr<Driver> driver;
  std::string trouble;  ///< why it has ended, when nobody asked it to
  bool connected = false, over = false, ended = false;
};

}  // namespace hw
