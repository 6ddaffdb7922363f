// A line of emulated DMX-K-SA with their own driver, in virtual time with the byte times of 115,200 baud:
// what one that is switched off costs the others, and what two with one name look like.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/pump.h"
#include "core/device/registry.h"
#include "core/session/shared_wire.h"
#include "core/time/virtual_scheduler.h"
#include "transports/serve.h"

namespace hw {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

class DmxBus : public ::testing::Test {
 protected:
  struct Member {
    Catalog catalog;
    Snapshot latest;
    TrafficRing traffic{1 << 16};
    std::unique_ptr<Pump> pump;
    std::vector<std::string> notices;
    [[nodiscard]] std::string sentence() const { return std::string(latest.link.sentence.view()); }
  };

  /// Names as they are on the line: two may be equal.
  void build(const std::vector<std::string>& names) {
    std::vector<HostedDevice> devices;
    for (std::size_t i = 0; i < names.size(); ++i) {
      auto emulator = type->make_emulator({{"id", names[i]}}).value();
      emulator->receive("@" + names[i] + "DB=5\r@" + names[i] + "STORE\r");
      ASSERT_TRUE(emulator->operate(bench::PowerCycle()));
      std::string said;
      emulator->take_output(said);
      devices.push_back(HostedDevice{std::to_string(i), std::move(emulator)});
    }
    HostOptions options;
    options.byte_times = true;
    host = *EmulatorHost::make(time, std::move(devices), options);
    wire = std::make_shared<SharedWire>(
        time, Address(), [this](Scheduler&, Address, std::shared_ptr<BenchAccess>) { return open(); });
  }
  Member& connect(const std::string& id) {
    auto member = std::make_unique<Member>();
    member->catalog = type->make_catalog({{"id", id}}).value();
    Pump::Ways ways;
    ways.open_wire = [this] { return wire->link(); };
    ways.publish = [m = member.get()](const Snapshot& s) { m->latest = s; };
    ways.notify = [m = member.get()](Notice n) { m->notices.push_back(std::move(n.text)); };
    ways.traffic = &member->traffic;
    member->pump = std::make_unique<Pump>(time, *type, member->catalog, std::move(ways));
    member->pump->start();
    members.push_back(std::move(member));
    return *members.back();
  }
  void build_thirty() {
    std::vector<std::string> names;
    for (int i = 1; i <= 30; ++i)
      names.push_back({static_cast<char>('0' + i / 10), static_cast<char>('0' + i % 10)});
    build(names);
    for (const std::string& name : names) connect(name);
    run(5);  // each has been read once
    for (const auto& member : members)
      ASSERT_EQ(member->latest.link.state, LinkState::good) << member->sentence();
  }
  void TearDown() override {
    for (const auto& member : members) asio::co_spawn(io, member->pump->shut_down(), asio::detached);
    run(3);
  }
  Task<Result<Wire>> open() {
    auto stream = host->plug_in();
    if (!stream) co_return fail(stream.error());
    Wire opened_wire;
    opened_wire.stream = std::move(*stream);
    co_return opened_wire;
  }
  void run(double s) { time.run_for(from_seconds(s)); }

  struct Question {
    Instant at;
    std::size_t member;
    bool is_round;  ///< begins a round of status
  };
  /// What has gone out since the last call, by its time.
  std::vector<Question> sent() {
    std::vector<Question> all;
    for (std::size_t i = 0; i < members.size(); ++i)
      members[i]->traffic.drain([&](const TrafficEntry& e) {
        if (e.way == Way::sent) all.push_back({e.at, i, e.bytes.find("MST") != std::string::npos});
      });
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    return all;
  }

  const DeviceType* type = find_device_type("dmx-k-sa");
  IoContext io;
  VirtualScheduler time{io};
  std::shared_ptr<EmulatorHost> host;
  std::shared_ptr<SharedWire> wire;
  std::vector<std::unique_ptr<Member>> members;
};

TEST_F(DmxBus, OneThatIsSwitchedOffTakesLittleFromTheOthers) {
  build_thirty();
  constexpr std::size_t dead = 12;
  ASSERT_TRUE(host->bench(dead)->operate(bench::Power(false)));
  run(5);
  ASSERT_EQ(members[dead]->latest.link.state, LinkState::lost);
  sent();
  constexpr double span = 12;
  run(span);
  std::vector<int> rounds(members.size());
  Duration silence{};
  const auto all = sent();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    rounds[all[i].member] += all[i].is_round ? 1 : 0;
    if (all[i].member == dead) silence += all[i + 1].at - all[i].at;
  }
  EXPECT_LT(seconds(silence), 0.03 * span) << "of the line's time";
  EXPECT_GT(seconds(silence), 0) << "it is asked again and again";
  rounds.erase(rounds.begin() + dead);
  const auto [fewest, most] = std::minmax_element(rounds.begin(), rounds.end());
  EXPECT_LE(*most - *fewest, std::max(1.0, 0.03 * *fewest)) << *fewest << " to " << *most;
  EXPECT_GT(*fewest, 10);
  for (std::size_t i = 0; i < members.size(); ++i)
    if (i != dead) {
      EXPECT_EQ(members[i]->latest.link.timeouts, 0u) << i;
    }
}

TEST_F(DmxBus, AStopWaitsNoLongerForASilentOneThanItsPatience) {
  build_thirty();
  constexpr std::size_t dead = 12;
  ASSERT_TRUE(host->bench(dead)->operate(bench::Power(false)));
  members[dead]->traffic.drain([](const TrafficEntry&) {});
  bool asked = false;
  while (!asked) {
    run(0.001);
    members[dead]->traffic.drain([&](const TrafficEntry& e) { asked = asked || e.way == Way::sent; });
  }
  Member& other = *members.front();
  other.traffic.drain([](const TrafficEntry&) {});
  const Instant wished_at = time.now();
  other.pump->post(Intent(1, intent::Stop()));
  run(0.5);
  Duration waited = Millis(500);
  other.traffic.drain([&](const TrafficEntry& e) {
    if (e.way == Way::sent && e.kind == TrafficKind::stop) waited = std::min(waited, e.at - wished_at);
  });
  EXPECT_LT(waited, Millis(55)) << "not 200 ms: 29 others have answered at once";
}

TEST_F(DmxBus, TwoWithOneNameAreNotTakenForADevice) {
  build({"01", "01"});
  Member& member = connect("01");
  run(2);
  EXPECT_EQ(member.latest.link.state, LinkState::lost);
  EXPECT_THAT(member.sentence(), AnyOf(HasSubstr("two devices with one address"),
                                       HasSubstr("More than one device answers at address 01")));
  EXPECT_THAT(member.sentence(), HasSubstr("Connect one"));
  EXPECT_FALSE(member.latest.axes[0].position_known);
}

// A second one gets the name of the first while both are connected, as a careless STORE and a power cut do
// it.
TEST_F(DmxBus, ASecondOneOfTheSameNameIsSaidAndItsPositionsAreNotShown) {
  build({"01", "02"});
  Member& first = connect("01");
  Member& second = connect("02");
  run(3);
  ASSERT_EQ(first.latest.link.state, LinkState::good);
  first.pump->post(Intent(1, intent::SetPosition(0, Steps(1234))));
  run(1);
  ASSERT_EQ(first.latest.axes[0].position, Steps(1234));
  second.pump->post(Intent(1, intent::SetParam("DN", 1, true)));
  second.pump->post(Intent(2, intent::Store()));
  run(2);
  ASSERT_TRUE(host->bench(1)->operate(bench::PowerCycle()));
  for (int i = 0; i < 100; ++i) {
    run(0.1);
    if (first.latest.axes[0].position_known) {
      EXPECT_EQ(first.latest.axes[0].position, Steps(1234));
    }
  }
  EXPECT_NE(second.latest.link.state, LinkState::good) << "nobody has its name any more";
  EXPECT_EQ(first.latest.link.state, LinkState::late);
  EXPECT_THAT(first.sentence(), AnyOf(HasSubstr("two devices have one address"),
                                      HasSubstr("More than one device answers at address 01")));
  EXPECT_TRUE(is_stale(first.latest.axes[0].seen_at, time.now(), first.latest.poll_period));
  // One of them gone, all is well again without a hand.
  ASSERT_TRUE(host->bench(1)->operate(bench::Power(false)));
  run(3);
  EXPECT_EQ(first.latest.link.state, LinkState::good) << first.sentence();
  EXPECT_EQ(first.latest.axes[0].position, Steps(1234));
}

}  // namespace
}  // namespace hw
