// What every kind of controller that can share a line must do on one, through the real wire, links, drivers
// and sessions in virtual time.
#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/session_group.h"
#include "core/time/virtual_scheduler.h"
#include "transports/open.h"

namespace hw {
namespace {

class BusContract : public testing::TestWithParam<const DeviceType*> {
 protected:
  void open(const std::string& keys) {
    const auto address = Address::parse(fmt::format("{}@emulator,{}", GetParam()->model, keys));
    ASSERT_TRUE(address) << address.error().sentence();
    auto opened = SessionGroup::open(time, *address, make_wire_opener(), [] {});
    ASSERT_TRUE(opened) << opened.error().sentence();
    bus = *opened;
    ASSERT_TRUE(
        run_until([this] { return all([](const Snapshot& s) { return s.link.state == LinkState::good; }); },
                  std::chrono::seconds(60)));
    time.run_for(std::chrono::seconds(2));
  }
  void TearDown() override {
    if (!bus) return;
    asio::co_spawn(io, bus->close(), asio::detached);
    time.run_for(std::chrono::seconds(2));
    EXPECT_TRUE(all([](const Snapshot& s) { return s.link.state == LinkState::closed; }));
  }
  bool run_until(const std::function<bool()>& done, Duration patience) {
    return time.run_until(time.now() + patience, done);
  }
  bool all(const std::function<bool(const Snapshot&)>& holds) {
    return std::all_of(bus->members().begin(), bus->members().end(),
                       [&](const auto& member) { return holds(member->known()); });
  }
  Session& device(const std::string& id) { return *bus->members()[static_cast<std::size_t>(bus->find(id))]; }
  static Steps position(Session& session) { return session.known().axes[0].position; }
  bool rest() {
    time.run_for(Millis(500));
    return run_until([this] { return all([](const Snapshot& s) { return !s.any_axis_moving(); }); },
                     std::chrono::seconds(60));
  }

  IoContext io;
  VirtualScheduler time{io};
  std::shared_ptr<SessionGroup> bus;
};

TEST_P(BusContract, EachMovesByItself) {
  open("id=01-04");
  ASSERT_EQ(bus->members().size(), 4u);
  EXPECT_EQ(device("03").address().options.at("id"), "03");
  device("03").send(intent::MoveBy({{AxisId{0}, Steps(500)}}));
  ASSERT_TRUE(rest());
  EXPECT_EQ(position(device("03")).value, 500);
  for (const char* other : {"01", "02", "04"}) EXPECT_EQ(position(device(other)).value, 0) << other;
}

TEST_P(BusContract, AStopOfAllStopsAll) {
  open("id=01-04");
  for (const auto& member : bus->members())
    member->send(intent::JogStart(AxisId{0}, Sign::plus, Pps(), false));
  time.run_for(Millis(500));
  ASSERT_TRUE(all([](const Snapshot& s) { return s.any_axis_moving(); }));
  bus->stop();
  EXPECT_TRUE(rest());
}

TEST_P(BusContract, ThirtyArePolledEvenlyOnAWireThatIsFull) {
  open("id=01-30,wire=real");
  const auto drain = [](Session& session, std::size_t& bytes) {
    std::size_t polls = 0;
    session.traffic().drain([&](TrafficEntry& e) {
      bytes += e.bytes.size();
      if (e.way == Way::sent && e.kind == TrafficKind::poll) ++polls;
    });
    return polls;
  };
  std::size_t bytes = 0;
  for (const auto& member : bus->members()) drain(*member, bytes);
  bytes = 0;
  constexpr int span = 60;
  time.run_for(std::chrono::seconds(span));
  std::size_t fewest = ~std::size_t{0}, most = 0;
  for (const auto& member : bus->members()) {
    const std::size_t polls = drain(*member, bytes);
    fewest = std::min(fewest, polls), most = std::max(most, polls);
  }
  EXPECT_LE(static_cast<double>(most - fewest), 0.03 * static_cast<double>(fewest))
      << fewest << " to " << most;
  const int baud = bus->members().front()->catalog().can.usual_baud;
  EXPECT_GE(10.0 * static_cast<double>(bytes) / (baud * span), 0.95) << "of what the wire can carry";
}

std::vector<const DeviceType*> addressed_types() {
  std::vector<const DeviceType*> all;
  for (const DeviceType& type : device_types())
    if (const auto catalog = type.make_catalog({});
        catalog && catalog->addressed() && type.make_driver && type.make_emulator)
      all.push_back(&type);
  return all;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(BusContract);
INSTANTIATE_TEST_SUITE_P(EachModel, BusContract, testing::ValuesIn(addressed_types()), [](const auto& info) {
  std::string name(info.param->model);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace hw
