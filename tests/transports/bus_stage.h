#pragma once
// Consoles on one line, in virtual time: emulators with the byte times of their rate, one wire, and for each
// device a pump, as the console has them.
#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/device/pump.h"
#include "core/session/shared_wire.h"
#include "core/time/virtual_scheduler.h"
#include "transports/serve.h"

namespace hw::test {

class BusStage {
 public:
  struct Member {
    Catalog catalog;
    Snapshot latest;
    TrafficRing traffic{1 << 16};
    std::vector<std::string> notices;
    std::function<void(const Snapshot&)> published;  ///< sees each snapshot
    std::unique_ptr<Pump> pump;

    [[nodiscard]] std::string sentence() const { return std::string(latest.link.sentence.view()); }
  };

  /// "01", "02" ...
  static std::string id_of(int number) {
    return {static_cast<char>('0' + number / 10), static_cast<char>('0' + number % 10)};
  }

  void serve(std::vector<HostedDevice> devices) {
    HostOptions options;
    options.byte_times = true;
    host = *EmulatorHost::make(time, std::move(devices), options);
    wire = std::make_shared<SharedWire>(
        time, Address(), [this](Scheduler&, Address, std::shared_ptr<BenchAccess>) { return open(); });
  }
  Member& connect(const DeviceType& type, Catalog catalog) {
    members.push_back(std::make_unique<Member>());
    Member& member = *members.back();
    member.catalog = std::move(catalog);
    Pump::Callbacks callbacks;
    callbacks.open_wire = [this] { return link(); };
    callbacks.line = wire->line();
    callbacks.publish = [&member](const Snapshot& s) {
      member.latest = s;
      if (member.published) member.published(s);
    };
    callbacks.notify = [&member](Notice n) { member.notices.push_back(std::move(n.text)); };
    callbacks.traffic = &member.traffic;
    member.pump = std::make_unique<Pump>(time, type, member.catalog, std::move(callbacks));
    member.pump->start();
    return member;
  }
  void close_all() {
    for (const auto& member : members) asio::co_spawn(io, member->pump->shut_down(), asio::detached);
    run(3);
  }
  void run(double s) { time.run_for(from_seconds(s)); }

  struct Sent {
    std::size_t member;
    TrafficEntry entry;
  };
  /// What has gone out since the last call, by its time.
  std::vector<Sent> sent() {
    std::vector<Sent> all;
    for (std::size_t i = 0; i < members.size(); ++i)
      members[i]->traffic.drain([&](const TrafficEntry& e) {
        if (e.way == Way::sent) all.push_back({i, e});
      });
    std::stable_sort(all.begin(), all.end(),
                     [](const Sent& a, const Sent& b) { return a.entry.at < b.entry.at; });
    return all;
  }

  IoContext io{1};
  VirtualScheduler time{io};
  std::shared_ptr<EmulatorHost> host;
  std::shared_ptr<SharedWire> wire;
  std::vector<std::unique_ptr<Member>> members;
  std::weak_ptr<Link> open_link;  ///< while somebody has it
  int opened = 0;                 ///< how often the wire was

 private:
  Task<Result<std::shared_ptr<Link>>> link() {
    auto shared = co_await wire->link();
    if (shared) open_link = *shared;
    co_return shared;
  }
  Task<Result<Wire>> open() {
    ++opened;
    auto stream = host->plug_in();
    if (!stream) co_return fail(stream.error());
    Wire opened_wire;
    opened_wire.stream = std::move(*stream);
    co_return opened_wire;
  }
};

}  // namespace hw::test
