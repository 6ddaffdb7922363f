// Thirty controllers on one line: pumps, stations, link, wire with byte times, emulators, all in virtual
// time.
#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/transports/bus_stage.h"
#include "tests/transports/ear.h"
#include "tests/transports/toy_bus.h"

namespace hw {
namespace {

using test::BusToy;
using testing::HasSubstr;

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<test::BusToyDriver>(std::move(context));
}

class Bus : public ::testing::Test, protected test::BusStage {
 protected:
  static constexpr int devices = 30;

  void SetUp() override {
    type.make_driver = &make_driver;
    std::vector<HostedDevice> toys;
    for (int i = 1; i <= devices; ++i)
      toys.push_back(HostedDevice{id_of(i), std::make_unique<BusToy>(id_of(i))});
    serve(std::move(toys));
    for (int i = 1; i <= devices; ++i) {
      Catalog catalog;
      catalog.address = i;
      catalog.axes.push_back({"X", "motor"});
      connect(type, std::move(catalog));
    }
    run(1);
  }
  void TearDown() override {
    close_all();
    for (const auto& member : members) EXPECT_EQ(member->latest.link.state, LinkState::closed);
  }
  const BusToy& toy(int i) {
    return static_cast<const BusToy&>(host->bench(static_cast<std::size_t>(i))->emulator());
  }
  std::vector<int> polls() {
    std::vector<int> all;
    for (int i = 0; i < devices; ++i) all.push_back(toy(i).polls);
    return all;
  }

  DeviceType type{};
};

TEST_F(Bus, EachOfThirtyIsPolledAsOftenAsTheOthersAndTheWireIsNeverIdle) {
  const auto before = polls();
  constexpr double span = 2;
  run(span);
  const auto after = polls();
  int fewest = 1 << 30, most = 0, all = 0;
  for (int i = 0; i < devices; ++i) {
    const int n = after[static_cast<std::size_t>(i)] - before[static_cast<std::size_t>(i)];
    fewest = std::min(fewest, n), most = std::max(most, n), all += n;
  }
  EXPECT_LE(most - fewest, 0.03 * fewest) << fewest << " to " << most;
  constexpr double bits_of_a_poll = 10 * (5 + 5);  // @01P<CR> 0400<CR>
  EXPECT_GE(all * bits_of_a_poll / (115200 * span), 0.95) << "of what the wire can carry";
  EXPECT_EQ(opened, 1);
}

TEST_F(Bus, AStopWaitsForNoMoreThanTheTransactionOnTheWire) {
  for (const int device : {0, 16, 29}) {
    sent();
    const Instant asked_at = time.now();
    members[static_cast<std::size_t>(device)]->pump->post(Intent(1, intent::Stop()));
    run(0.02);
    int before_it = 0;
    for (const auto& [member, e] : sent()) {
      if (e.kind == TrafficKind::stop) {
        EXPECT_LT(e.at - asked_at, 11 * byte_time(115200)) << "device " << device;
        break;
      }
      if (e.at > asked_at) ++before_it;
    }
    EXPECT_EQ(before_it, 0) << "nothing began between the wish and the stop of device " << device;
    EXPECT_EQ(toy(device).stops, 1);
  }
}

TEST_F(Bus, AStopOfAllIsOneMessageAndThenEachDevice) {
  sent();
  members.front()->pump->stop_wire(false);
  for (const auto& member : members) member->pump->post(Intent(1, intent::Stop()));
  run(0.5);
  std::vector<std::string> stops;
  for (const auto& [member, e] : sent())
    if (e.kind == TrafficKind::stop) stops.push_back(e.bytes);
  ASSERT_EQ(stops.size(), 31u);
  EXPECT_EQ(stops.front(), "@00S\r");
  for (int i = 0; i < devices; ++i) EXPECT_EQ(toy(i).stops, 2);
}

TEST_F(Bus, OneThatIsSwitchedOffIsLostAndTheOthersAreNot) {
  ASSERT_TRUE(host->bench(4)->operate(bench::Power(false)));
  run(3);
  EXPECT_NE(members[4]->latest.link.state, LinkState::good);
  EXPECT_GT(members[4]->latest.link.lost_at, Instant{});
  for (int i = 0; i < devices; ++i)
    if (i != 4) {
      EXPECT_EQ(members[static_cast<std::size_t>(i)]->latest.link.state, LinkState::good) << i;
    }
  EXPECT_EQ(opened, 1) << "the wire is not lost";
  ASSERT_TRUE(host->bench(4)->operate(bench::Power(true)));
  run(6);
  EXPECT_EQ(members[4]->latest.link.state, LinkState::good);
  EXPECT_EQ(opened, 1);
}

TEST_F(Bus, APulledCableIsLostForAllAndOpenedOnceForAll) {
  ASSERT_TRUE(host->bench(0)->operate(bench::Unplug(true)));
  run(0.1);
  for (const auto& member : members) {
    EXPECT_EQ(member->latest.link.state, LinkState::lost);
    EXPECT_THAT(std::string(member->latest.link.sentence.view()), HasSubstr("was pulled"));
  }
  run(20);
  EXPECT_LT(opened, 10) << "one attempt answers all";
  ASSERT_TRUE(host->bench(0)->operate(bench::Unplug(false)));
  opened = 0;
  run(6);
  for (const auto& member : members) EXPECT_EQ(member->latest.link.state, LinkState::good);
  EXPECT_EQ(opened, 1);
}

TEST_F(Bus, TheLastToLeaveClosesTheWire) {
  for (std::size_t i = 1; i < members.size(); ++i)
    asio::co_spawn(io, members[i]->pump->shut_down(), asio::detached);
  run(0.1);
  EXPECT_FALSE(open_link.expired());
  EXPECT_EQ(members.front()->latest.link.state, LinkState::good);
  asio::co_spawn(io, members.front()->pump->shut_down(), asio::detached);
  run(0.1);
  EXPECT_TRUE(open_link.expired());
}

// ---- the host of several

TEST(HostOfSeveral, EachHasABenchAndAMemoryOfItsOwn) {
  IoContext io;
  VirtualScheduler time(io);
  const auto file = std::filesystem::temp_directory_path() / ("hw-bus-" + std::to_string(::getpid()));
  HostOptions options;
  options.state_file = file;
  const auto make = [&](std::vector<std::string> ids) {
    std::vector<HostedDevice> toys;
    for (const std::string& id : ids) toys.push_back(HostedDevice{id, std::make_unique<BusToy>(id)});
    return EmulatorHost::make(time, std::move(toys), options);
  };
  {
    auto host = make({"01", "07"});
    ASSERT_TRUE(host);
    ASSERT_TRUE((*host)->bench(1)->operate(bench::Power(false)));
    BenchView first, second;
    (*host)->bench(0)->look(first);
    (*host)->bench(1)->look(second);
    EXPECT_TRUE(first.powered);
    EXPECT_FALSE(second.powered);
    ASSERT_TRUE((*host)->bench(1)->operate(bench::Power(true)));
    auto stream = *(*host)->plug_in();
    test::Ear ear(*stream);
    stream->send("@01S\r@07S\r@03S\r");
    time.run_for(Millis(10));
    EXPECT_EQ(ear.received, "OK\rOK\r");
  }
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".01"));
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".07"));
  EXPECT_TRUE(make({"01", "07"})) << "each finds its own again";
  std::filesystem::rename(file.string() + ".01", file.string() + ".07");
  EXPECT_FALSE(make({"01", "07"}));
  std::filesystem::remove(file.string() + ".07");
}

TEST(HostOfSeveral, OneAtAnotherRateReceivesAndSendsNonsenseAlone) {
  IoContext io;
  VirtualScheduler time(io);
  std::vector<HostedDevice> toys;
  toys.push_back(HostedDevice{"01", std::make_unique<BusToy>("01", 115200)});
  toys.push_back(HostedDevice{"02", std::make_unique<BusToy>("02", 9600)});
  HostOptions options;
  options.byte_times = true;
  auto host = *EmulatorHost::make(time, std::move(toys), options);
  auto stream = *host->plug_in(115200);
  test::Ear ear(*stream);
  stream->send("@01P\r@02P\r");
  time.run_for(Millis(100));
  EXPECT_EQ(ear.received, "0400\r");
  EXPECT_EQ(static_cast<const BusToy&>(host->bench(1)->emulator()).polls, 0);
}

}  // namespace
}  // namespace hw
