// A line of emulated DMX-K-SA with their own driver, in virtual time with the byte times of 115,200 baud:
// what one that is switched off costs the others, and what two with one name look like.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/registry.h"
#include "tests/transports/bus_stage.h"
#include "tests/transports/late_emulator.h"

namespace hw {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class DmxBus : public ::testing::Test, protected test::BusStage {
 protected:
  /// Names as they are on the line: two may be equal.
  void build(const std::vector<std::string>& names) {
    std::vector<HostedDevice> devices;
    for (std::size_t i = 0; i < names.size(); ++i) {
      auto emulator = std::make_unique<test::LateEmulator>(type->make_emulator({{"id", names[i]}}).value());
      emulator->receive("@" + names[i] + "DB=5\r@" + names[i] + "STORE\r");
      ASSERT_TRUE(emulator->operate(bench::PowerCycle()));
      std::string sentence;
      emulator->take_output(sentence);
      emulators.push_back(emulator.get());
      devices.push_back(HostedDevice{std::to_string(i), std::move(emulator)});
    }
    serve(std::move(devices));
  }
  Member& connect(const std::string& id) {
    return BusStage::connect(*type, type->make_catalog({{"id", id}}).value());
  }
  void build_and_connect(int count) {
    std::vector<std::string> names;
    for (int i = 1; i <= count; ++i) names.push_back(id_of(i));
    build(names);
    for (const std::string& name : names) connect(name);
    run(5);  // each has been read once
    for (const auto& member : members)
      ASSERT_EQ(member->latest.link.state, LinkState::good) << member->sentence();
  }
  void TearDown() override { close_all(); }

  void send(Member& member, std::string text, bool to_all = false) {
    member.pump->post(Intent(++last_id, intent::SendText(std::move(text), to_all)));
  }
  /// For seconds, and everything that it is asked after that waits.
  void ask_nobody(Member& member) {
    asio::co_spawn(
        io,
        [](Pump& pump) -> Task<> {
          auto reply = co_await pump.query("@29PX", std::chrono::seconds(5));
          EXPECT_FALSE(reply);
        }(*member.pump),
        asio::detached);
    run(0.1);
  }
  /// A move that stands in the device's own queue.
  void let_move_wait(Member& member) {
    send(member, "EO=1");
    run(0.5);
    ask_nobody(member);
    send(member, "X100000");
  }
  bool goes_out(const char* text) {
    return time.run_until(time.now() + from_seconds(1), [&] {
      const auto all = sent();
      return std::any_of(all.begin(), all.end(),
                         [&](const Sent& s) { return s.entry.bytes.starts_with(text); });
    });
  }
  static bool moves(const Member& member) { return member.latest.any_axis_moving(); }

  IntentId last_id = 0;
  const DeviceType* type = find_device_type("dmx-k-sa");
  std::vector<test::LateEmulator*> emulators;
};

TEST_F(DmxBus, OneThatIsSwitchedOffTakesLittleFromTheOthers) {
  build_and_connect(30);
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
    const bool begins_round = all[i].entry.bytes.find("MST") != std::string::npos;
    rounds[all[i].member] += begins_round ? 1 : 0;
    if (all[i].member == dead) silence += all[i + 1].entry.at - all[i].entry.at;
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
  build_and_connect(30);
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
  const Instant requested_at = time.now();
  other.pump->post(Intent(1, intent::Stop()));
  run(0.5);
  Duration waited = Millis(500);
  other.traffic.drain([&](const TrafficEntry& e) {
    if (e.way == Way::sent && e.kind == TrafficKind::stop) waited = std::min(waited, e.at - requested_at);
  });
  EXPECT_LT(waited, Millis(55)) << "not 200 ms: 29 others have answered at once";
}

TEST_F(DmxBus, AStopTypedToAllDropsWhatWaitedForAnotherDevice) {
  build_and_connect(2);
  Member& other = *members[1];
  let_move_wait(other);
  send(*members[0], "STOP", true);
  run(2);
  EXPECT_FALSE(moves(other));
  ASSERT_TRUE(other.latest.outcome_of(last_id - 1));
  EXPECT_EQ(other.latest.outcome_of(last_id - 1)->state, IntentState::refused);
  send(other, "X100000");
  run(1);
  EXPECT_TRUE(moves(other)) << "what is asked after the stop is done";
}

TEST_F(DmxBus, AStopTypedForAnotherDeviceWaitsForNothing) {
  build_and_connect(2);
  send(*members[1], "EO=1");
  send(*members[1], "X100000");
  run(1);
  ASSERT_TRUE(moves(*members[1]));
  ask_nobody(*members[0]);
  send(*members[0], "@02STOP");
  run(1);
  EXPECT_FALSE(moves(*members[1]));
}

// It waits there behind a round of status, which is long where another device is silent.
TEST_F(DmxBus, AStopDropsWhatWaitsForItInAnotherDevicesQueue) {
  using Send = std::function<void()>;
  build_and_connect(3);
  Member &speaker = *members[0], &other = *members[1];
  send(other, "EO=1");
  run(0.5);
  ASSERT_TRUE(host->bench(2)->operate(bench::Power(false)));
  const Send motions[] = {[&] { send(speaker, "@02J+"); }, [&] { send(speaker, "J+", true); },
                          [&] { send(speaker, "@00J+"); }};
  const Send stops[] = {[&] { other.pump->post(Intent(++last_id, intent::Stop())); },
                        [&] { send(other, "STOP"); }, [&] { send(speaker, "@02STOP"); }};
  for (const Send& move : motions)
    for (const Send& stop : stops) {
      for (int after_ms = 0; after_ms < 60; after_ms += 6) {
        move();
        run(after_ms * 0.001);
        stop();
        run(2);
        ASSERT_FALSE(moves(other)) << &move - motions << ' ' << &stop - stops << ' ' << after_ms;
      }
      move();
      run(1);
      ASSERT_TRUE(moves(other)) << "what is asked after the stop is done";
      stop();
      run(2);
    }
}

// What the speaker's own jog has borrowed is given back first, and takes its time.
TEST_F(DmxBus, AStopDropsWhatAnotherDeviceIsAboutToSend) {
  build_and_connect(3);
  Member &speaker = *members[0], &other = *members[1];
  send(speaker, "EO=1");
  send(other, "EO=1");
  run(0.5);
  for (const char* text : {"@02J+", "@00J+"}) {
    sent();
    speaker.pump->post(Intent(++last_id, intent::JogStart(AxisId{0}, Sign::plus, Pps(300))));
    ASSERT_TRUE(goes_out("@01J+"));
    speaker.pump->post(Intent(++last_id, intent::Stop()));
    send(speaker, text);
    ASSERT_TRUE(goes_out("@01HSPD=1000"));
    send(*members[2], "@02STOP");
    run(2);
    EXPECT_FALSE(moves(other)) << text;
    send(speaker, "STOP", true);
    run(1);
  }
  for (const auto& member : members) EXPECT_THAT(member->notices, IsEmpty());
}

TEST_F(DmxBus, AStopOfOneThatIsNotConnectedTakesBackWhatWaitsForItElsewhere) {
  build_and_connect(3);
  Member &speaker = *members[0], &other = *members[1];
  send(other, "EO=1");
  run(0.5);
  const std::function<void()> stops[] = {[&] { other.pump->post(Intent(++last_id, intent::Stop())); },
                                         [&] { send(other, "STOP"); }, [&] { send(*members[2], "@02STOP"); }};
  for (const auto& stop : stops)
    for (const LinkState state : {LinkState::lost, LinkState::connecting}) {
      emulators[1]->be_deaf(true);
      run(25);
      if (state == LinkState::lost) {  // for the others it is another wire already
        ASSERT_TRUE(host->bench(0)->operate(bench::Unplug(true)));
        run(0.2);
        ASSERT_TRUE(host->bench(0)->operate(bench::Unplug(false)));
        ASSERT_TRUE(time.run_until(time.now() + from_seconds(3),
                                   [&] { return speaker.latest.link.state == LinkState::good; }));
      }
      ask_nobody(speaker);
      send(speaker, "@02J+");
      ASSERT_TRUE(
          time.run_until(time.now() + from_seconds(10), [&] { return other.latest.link.state == state; }));
      emulators[1]->be_deaf(false);
      stop();
      run(12);
      EXPECT_FALSE(moves(other)) << &stop - stops;
      EXPECT_EQ(other.latest.link.state, LinkState::good);
    }
}

TEST_F(DmxBus, ACommandForADeviceBeingStoppedWaitsThere) {
  build_and_connect(2);
  Member &speaker = *members[0], &other = *members[1];
  for (const char* text : {"EO=1", "HSPD=20000", "ACC=2000", "J+"}) send(other, text);
  run(3);
  ASSERT_TRUE(moves(other));
  other.pump->post(Intent(++last_id, intent::Stop()));
  const IntentId stop = last_id;
  run(0.3);
  sent();
  send(speaker, "@02J+");
  const IntentId jog = last_id;
  ASSERT_TRUE(time.run_until(time.now() + from_seconds(5), [&] {
    return other.pump->known().outcome_of(stop)->state == IntentState::done;
  }));
  for (const Sent& s : sent())
    if (s.entry.bytes.ends_with("J+\r")) {
      EXPECT_EQ(s.entry.at, time.now()) << "it stands first";
    }
  run(1);
  EXPECT_EQ(speaker.latest.outcome_of(jog)->state, IntentState::done);
  EXPECT_TRUE(moves(other));
}

TEST_F(DmxBus, AnotherDeviceSetsItInMotionAsSoonAsTheStopHasEnded) {
  build_and_connect(4);
  Member &speaker = *members[0], &other = *members[1];
  send(other, "EO=1");
  run(0.5);
  for (int i = 0; i < 10; ++i) {
    other.pump->post(Intent(++last_id, intent::Stop()));
    const IntentId stop = last_id;
    ASSERT_TRUE(time.run_until(time.now() + from_seconds(5), [&] {
      return other.pump->known().outcome_of(stop)->state == IntentState::done;
    }));
    send(speaker, i % 2 == 0 ? "@02J+" : "@00J+");
    run(1);
    EXPECT_EQ(speaker.latest.outcome_of(last_id)->state, IntentState::done) << i;
    EXPECT_TRUE(moves(other)) << i;
  }
}

TEST_F(DmxBus, AStopOfOneTakesNothingFromTheOthers) {
  build_and_connect(3);
  Member &speaker = *members[0], &other = *members[1];
  send(other, "EO=1");
  run(0.5);
  ask_nobody(speaker);
  send(speaker, "@02V1=7");
  const IntentId setting = last_id;
  send(speaker, "@02J+");
  send(other, "@03STOP");
  run(6);
  EXPECT_EQ(speaker.latest.outcome_of(setting)->state, IntentState::done);
  EXPECT_TRUE(moves(other));
}

// Each of several is answered, and an answer too many would be taken for another's.
TEST_F(DmxBus, ATextIsOneCommand) {
  build_and_connect(2);
  sent();
  send(*members[0], "V1=1\r@02V1=2");
  run(1);
  EXPECT_EQ(members[0]->latest.outcome_of(last_id)->state, IntentState::refused);
  send(*members[0], "V1=1\r@02J+", true);
  run(1);
  EXPECT_EQ(members[0]->latest.outcome_of(last_id)->state, IntentState::refused);
  send(*members[0], "STOP\r@02V1=2");
  run(1);
  EXPECT_EQ(members[0]->latest.outcome_of(last_id)->state, IntentState::failed);
  bool stopped = false;
  for (const Sent& s : sent()) {
    EXPECT_THAT(s.entry.bytes, Not(HasSubstr("V1=")));
    stopped = stopped || s.entry.bytes == "@01STOP\r";
  }
  EXPECT_TRUE(stopped);
}

TEST_F(DmxBus, AStopTypedToAllWithItsAddressIsReceivedByAll) {
  build_and_connect(2);
  Member& other = *members[1];
  let_move_wait(other);
  send(*members[0], "@00STOP", true);
  run(2);
  EXPECT_FALSE(moves(other));
}

// It is answered: by the one whose address it brings.
TEST_F(DmxBus, ATextToAllThatBringsAnAddressShiftsNoAnswers) {
  build_and_connect(3);
  std::vector<std::string> wrong;
  for (std::size_t i = 0; i < members.size(); ++i) {
    Member& member = *members[i];
    const Steps own(1000 * static_cast<int>(i + 1));
    member.pump->post(Intent(1, intent::SetPosition(0, own)));
    run(1);
    member.published = [&wrong, &member, own](const Snapshot& s) {
      if (s.axes[0].position_known && s.axes[0].position != own)
        wrong.push_back(member.catalog.id() + " at " + std::to_string(s.axes[0].position.value));
    };
  }
  send(*members[0], "@02PX", true);
  run(5);
  send(*members[0], "@02STOP", true);
  run(5);
  EXPECT_THAT(wrong, IsEmpty());
  for (const auto& member : members) EXPECT_THAT(member->notices, IsEmpty());
}

TEST_F(DmxBus, AStopLostWithTheLinkIsPendingForAllItsReceivers) {
  for (const bool at_once : {true, false}) {
    build_and_connect(3);
    for (const auto& member : members) {
      send(*member, "EO=1");
      send(*member, "HSPD=1000");
      send(*member, "X100000");
    }
    run(1);
    for (const auto& member : members) ASSERT_TRUE(moves(*member));
    for (test::LateEmulator* emulator : emulators) emulator->be_deaf(true);
    if (at_once) {
      send(*members[0], "STOP", true);
    } else {
      send(*members[0], "@02STOP");
      send(*members[0], "@03STOP");
      send(*members[0], "STOP");
    }
    run(6);
    for (const auto& member : members) EXPECT_FALSE(member->latest.link.connected());
    for (test::LateEmulator* emulator : emulators) emulator->be_deaf(false);
    run(10);
    for (const auto& member : members) EXPECT_FALSE(moves(*member)) << member->catalog.id() << at_once;
    close_all();
    members.clear();
    emulators.clear();
  }
}

TEST_F(DmxBus, AStoreSentThroughAnotherDeviceCountsOnceConfirmed) {
  build_and_connect(2);
  Member& other = *members[1];
  other.pump->post(Intent(1, intent::SetParam("SLR", 900)));
  run(1);
  ASSERT_TRUE(other.latest.unsaved_setup);
  ASSERT_TRUE(host->bench(1)->operate(bench::Garble(2)));
  send(*members[0], "@02STORE");
  ASSERT_TRUE(host->bench(1)->operate(bench::Power(false)));
  run(0.2);
  EXPECT_TRUE(other.latest.unsaved_setup);
  run(5);
  EXPECT_TRUE(other.latest.unsaved_setup);
  ASSERT_TRUE(host->bench(1)->operate(bench::Power(true)));
  run(10);
  other.pump->post(Intent(2, intent::SetParam("SLR", 700)));
  run(1);
  ASSERT_TRUE(other.latest.unsaved_setup);
  send(*members[0], "@02STORE");
  run(1);
  EXPECT_FALSE(other.latest.unsaved_setup);
}

TEST_F(DmxBus, ASubroutineThatItRefusesAnotherDeviceWasNotCalled) {
  build_and_connect(2);
  Member& other = *members[1];
  send(*members[0], "@02GS3");
  run(1);
  const Instant asked = time.now();
  other.pump->post(Intent(1, intent::Stop()));
  ASSERT_TRUE(time.run_until(time.now() + from_seconds(20), [&] {
    const IntentOutcome* outcome = other.latest.outcome_of(1);
    return outcome && outcome->state != IntentState::pending;
  }));
  EXPECT_LT(seconds(time.now() - asked), 0.5);
}

TEST_F(DmxBus, OneThatIsStoppedWhileOthersAreBusyIsNeverReportedAsArrived) {
  build_and_connect(6);
  for (const auto& member : members) {
    send(*member, "EO=1");
    send(*member, "HSPD=20000");
    member->pump->post(Intent(1, intent::JogStart(AxisId{0}, Sign::plus, Pps{500}, false)));
  }
  run(1);
  Member& one = *members.front();
  one.pump->post(Intent(1, intent::Stop()));
  run(2);
  for (int i = 0; i < 60; ++i) {
    std::vector<AxisTarget> target(1);
    target[0].value = Steps(i % 2 == 0 ? 90000 : -90000);
    one.pump->post(Intent(100 + 2 * i, intent::MoveTo(target)));
    run(0.5 + 0.0037 * i);
    ASSERT_TRUE(moves(one)) << i;
    one.pump->post(Intent(101 + 2 * i, intent::Stop()));
    run(2);
    EXPECT_FALSE(moves(one)) << i;
    EXPECT_EQ(one.latest.axes[0].ended_by, EndedBy::stop) << i;
  }
}

TEST_F(DmxBus, TwoWithOneNameAreNotTakenForADevice) {
  build({"01", "01"});
  Member& member = connect("01");
  run(5);
  EXPECT_EQ(member.latest.link.state, LinkState::lost);
  EXPECT_THAT(member.sentence(), AnyOf(HasSubstr("two devices have the same address"),
                                       HasSubstr("More than one device answers at address 01")));
  EXPECT_THAT(member.sentence(), HasSubstr("Connect one"));
  EXPECT_FALSE(member.latest.axes[0].position_known);
}

// Replies carry no address: what comes late looks like the answer to the question that is asked just then.
class LateAnswers : public DmxBus, public testing::WithParamInterface<int> {};

TEST_P(LateAnswers, AreNotTakenForAnotherDevices) {
  build_and_connect(4);
  std::vector<std::string> wrong;
  for (std::size_t i = 0; i < members.size(); ++i) {
    Member& member = *members[i];
    const Steps own(1000 * static_cast<int>(i + 1));
    member.pump->post(Intent(1, intent::SetPosition(0, own)));
    run(1);
    ASSERT_EQ(member.latest.axes[0].position, own);
    member.published = [&wrong, &member, own](const Snapshot& s) {
      const AxisState& axis = s.axes[0];
      if (axis.position_known && (axis.position != own || axis.speed != Pps{} || axis.alarm))
        wrong.push_back(member.catalog.id() + " at " + std::to_string(axis.position.value));
    };
  }
  const Millis delay(GetParam());
  constexpr int phases = 12;
  for (int phase = 0; phase < phases; ++phase) {
    test::LateEmulator& late = *emulators[static_cast<std::size_t>(phase) % emulators.size()];
    late.be_late(1 + phase % 3, delay);
    run(7 + 0.017 * phase);
    ASSERT_TRUE(late.was_late());
  }
  EXPECT_THAT(wrong, IsEmpty());
  for (const auto& member : members) {
    EXPECT_EQ(member->latest.link.state, LinkState::good) << member->sentence();
    EXPECT_THAT(member->notices, IsEmpty());
  }
}

INSTANTIATE_TEST_SUITE_P(ByMilliseconds, LateAnswers,
                         testing::Values(60, 95, 105, 120, 150, 200, 300, 450, 700, 1000, 1500, 2500));

// A second one gets the name of the first while both are connected, as a careless STORE and a power cut do
// it.
TEST_F(DmxBus, ASecondOneOfTheSameNameIsReportedAndItsPositionsAreNotShown) {
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
  EXPECT_NE(first.latest.link.state, LinkState::good) << "each spoils the other's answers";
  EXPECT_THAT(first.sentence(), AnyOf(HasSubstr("two devices have the same address"),
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
